/*
 * Circular fiducial markers for ViSP, the Visual Servoing Platform.
 *
 * This software is free software; you can redistribute it and/or modify
 * it under the terms of the GNU General Public License as published by
 * the Free Software Foundation; either version 2 of the License, or
 * (at your option) any later version.
 * See the file LICENSE at the root directory of this source
 * distribution for additional information about the GNU GPL.
 *
 * This file is provided AS IS with NO WARRANTY OF ANY KIND, INCLUDING THE
 * WARRANTY OF DESIGN, MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE.
 *
 * Description:
 * Records images while the program goes on.
 */

#ifndef VP_TUTORIAL_RECORDER_H
#define VP_TUTORIAL_RECORDER_H

#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <visp3/core/vpImage.h>

#include "../common/numbered_name.h"
#include "../common/visp_names.h"

namespace tutorial {
/*!
  Writes images in a thread of its own: a PNG of 1280 x 960 takes longer than a camera at 15 images a second leaves.
  The lines of the images are written beside them, into poses.jsonl, at the end.
*/
class Recorder
{
public:
  /*!
    \param pattern : Names of the images, with a number from 0.
    \exception vpException::ioError : If the folder cannot be made.
  */
  explicit Recorder(const std::string &pattern);
  Recorder(const Recorder &) = delete;
  Recorder &operator=(const Recorder &) = delete;
  ~Recorder();

  /*! \return Name of the image that is recorded next. */
  std::string nextName() const { return m_name(m_number); }

  /*! Records an image under the next name. Waits where the disk is too slow: all images or none. */
  void record(const vpImage<unsigned char> &image, const std::string &line);

  /*! \return How many images were recorded. */
  long count() const { return m_number; }

  /*!
    Waits for the last image and writes poses.jsonl.
    \exception vpException::ioError : If something could not be written.
  */
  void finish();

private:
  void write();

  NumberedName m_name;  //!< Names of the images.
  std::string m_poses;  //!< Path of poses.jsonl.
  long m_number = 0;    //!< Of the next image.
  std::thread m_thread; //!< Writes.

  std::vector<std::string> m_lines; //!< Of the images, those that wait as well.

  std::mutex m_mutex; //!< Guards all below.
  std::condition_variable m_changed;
  std::deque<std::pair<std::string, vpImage<unsigned char>>> m_waiting; //!< To be written.
  std::size_t m_written = 0;                                            //!< Images.
  std::string m_problem;                                                //!< The first error.
  bool m_isEnd = false;                                                 //!< Whether nothing more comes.
};
} // namespace tutorial

#endif
