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
 * ViSP's own FireWire grabber, unchanged, on the simulated bus; and what this project does beside it.
 */

#include <cstdlib>
#include <fstream>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpConfig.h>

#if defined(VISP_HAVE_DC1394)
#include <visp3/sensor/vp1394TwoGrabber.h>
#endif

#include "common/cameras/firewire_camera.h"
#include "live_run.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace fs = std::filesystem;

namespace {
/*! Names of a library's dynamic symbols that begin with dc1394_. */
std::vector<std::string> symbols(const std::string &which, const std::string &library, const fs::path &folder)
{
  const test::Outcome outcome = test::run("nm", {"-D", which, "--format=posix", library}, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream in(outcome.out);
  std::vector<std::string> names;
  std::string line;
  while (std::getline(in, line)) {
    const std::string name = line.substr(0, line.find_first_of("@ "));
    if (name.rfind("dc1394_", 0) == 0) {
      names.push_back(name);
    }
  }
  return names;
}

/*! Path of the libvisp_sensor that a program uses. */
std::string sensorLibrary(const fs::path &folder)
{
  const test::Outcome outcome = test::run("ldd", {LIVE_PROGRAM}, folder);
  std::istringstream in(outcome.out);
  std::string line;
  while (std::getline(in, line)) {
    const std::size_t start = line.find("=> ");
    if (line.find("libvisp_sensor") != std::string::npos && start != std::string::npos) {
      return line.substr(start + 3, line.rfind(" (") - start - 3);
    }
  }
  return "";
}
} // namespace

// A call that the simulated library lacks would reach the real one, with cameras that are none of its own.
TEST(FireWireGrabber, NoCallEscapesTheSimulatedBus)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<std::string> known = symbols("--defined-only", SIMULATED_LIBRARY, folder);
  const std::string sensor = sensorLibrary(folder);
  ASSERT_FALSE(sensor.empty()) << "the live program does not use libvisp_sensor";
  for (const std::string &user : {sensor, std::string(LIVE_PROGRAM)}) {
    const std::vector<std::string> used = symbols("--undefined-only", user, folder);
    EXPECT_FALSE(used.empty()) << user;
    for (const std::string &name : used) {
      EXPECT_NE(std::find(known.begin(), known.end(), name), known.end()) << name << ", which " << user << " calls";
    }
  }
}

TEST(FireWireGrabber, AdviceSaysWhatIsMissing)
{
  const fs::path root = test::emptyFolder();
  EXPECT_NE(tutorial::fireWireAdvice(root).find("modprobe firewire-ohci"), std::string::npos);
  fs::create_directories(root / "sys/bus/usb/devices/1-2");
  std::ofstream(root / "sys/bus/usb/devices/1-2/idVendor") << "1e10\n";
  EXPECT_NE(tutorial::fireWireAdvice(root).find("USB camera of Point Grey is plugged in"), std::string::npos);
  EXPECT_NE(tutorial::fireWireAdvice(root).find("60-circle-marker-cameras.rules"), std::string::npos);
  fs::remove_all(root / "sys");
  fs::create_directories(root / "dev");
  std::ofstream(root / "dev/fw0") << "";
  std::ofstream(root / "dev/fwupd") << "";
  EXPECT_NE(tutorial::fireWireAdvice(root).find("check the cable"), std::string::npos);
  fs::remove(root / "dev/fw0");
  // Nobody may open it, root neither: it leads nowhere.
  fs::create_symlink("nowhere", root / "dev/fw1");
  const std::string advice = tutorial::fireWireAdvice(root);
  EXPECT_NE(advice.find("fw1 is there, but you may not read and write it"), std::string::npos) << advice;
  EXPECT_NE(advice.find("group video"), std::string::npos) << advice;
}

#if defined(VISP_HAVE_DC1394)
namespace {
/*! Runs the other half of a test, which needs the bus, in a process of its own. */
test::Outcome runInside(const std::string &name, const test::Json &bus, const fs::path &folder)
{
  return test::runOnBus(fs::read_symlink("/proc/self/exe"),
                        {"--gtest_also_run_disabled_tests", "--gtest_filter=Inside.DISABLED_" + name}, folder, bus);
}

using Grabber = vp1394TwoGrabber;

/*! What acquire() itself gives in a mode, and the poses found in it. */
void acquireAndDetect(Grabber &grabber, int images)
{
  std::ifstream file(std::getenv("CIRCLE_MARKER_SIMULATED_BUS"));
  const test::Json bus = test::Json::parse(file);
  const vpCameraParameters cam(1600., 1600., 639.5, 479.5);
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  detector.setZAlignedWithCameraAxis(true);
  vpImage<unsigned char> I;
  for (int i = 0; i < images; ++i) {
    std::uint64_t stamp = 0;
    std::uint32_t place = 0;
    grabber.acquire(I, stamp, place);
    ASSERT_EQ(I.getWidth(), 1280U);
    ASSERT_EQ(I.getHeight(), 960U);
    std::vector<vpHomogeneousMatrix> cMo;
    detector.detect(I, 0.18, cam, cMo);
    ASSERT_EQ(cMo.size(), 1U);
    const auto truth = bus["poses"][static_cast<std::size_t>(i) % bus["poses"].size()].get<std::vector<double>>();
    const test::PoseDistance distance = test::poseDistance(std::vector<double>(cMo[0].data, cMo[0].data + 16), truth);
    EXPECT_LT(distance.metres, 2e-4);
    EXPECT_LT(distance.degrees, 0.03);
  }
}
} // namespace

/*! Run on the simulated bus only, by the test below. */
TEST(Inside, DISABLED_AcquireInEveryMode)
{
  for (const auto mode : {Grabber::vpVIDEO_MODE_1280x960_MONO8, Grabber::vpVIDEO_MODE_1280x960_MONO16,
                          Grabber::vpVIDEO_MODE_1280x960_YUV422, Grabber::vpVIDEO_MODE_1280x960_RGB8}) {
    SCOPED_TRACE(Grabber::videoMode2string(mode));
    // A grabber of its own each time: the camera's frames are counted from 0 where the grabber starts anew.
    Grabber grabber(false);
    grabber.setCamera(0);
    grabber.setVideoMode(mode);
    if (mode != Grabber::vpVIDEO_MODE_1280x960_RGB8) {
      grabber.setFramerate(Grabber::vpFRAMERATE_15);
    }
    acquireAndDetect(grabber, 3);
  }
}

TEST(FireWireGrabber, AcquiresConvertsAndHandsImagesToTheDetector)
{
  const test::Outcome outcome = runInside("AcquireInEveryMode", test::chameleonBus(), test::emptyFolder());
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("1 test"), std::string::npos) << outcome.out;
}

/*! Run on the simulated bus only, by the test below. */
TEST(Inside, DISABLED_SameImages)
{
  std::ifstream file(std::getenv("CIRCLE_MARKER_SIMULATED_BUS"));
  const std::string coding = test::Json::parse(file)["coding"];
  vpImage<unsigned char> ours, theirs;
  {
    tutorial::CameraSettings settings;
    settings.address = "0";
    settings.name = "firewire:0";
    settings.videoMode = "format7_0";
    settings.colorCoding = coding;
    settings.region = tutorial::ImageRegion{320, 240, 640, 480};
    const std::unique_ptr<tutorial::FrameSource> camera = tutorial::openFireWireCamera(settings);
    ours = camera->next()->image;
  }
  Grabber grabber(false);
  grabber.setCamera(0);
  grabber.setVideoMode(Grabber::vpVIDEO_MODE_FORMAT7_0);
  std::string upper = "COLOR_CODING_";
  std::transform(coding.begin(), coding.end(), std::back_inserter(upper), ::toupper);
  grabber.setColorCoding(Grabber::string2colorCoding(upper));
  grabber.setFormat7ROI(320, 240, 640, 480);
  grabber.acquire(theirs);
  ASSERT_EQ(ours.getWidth(), 640U);
  ASSERT_EQ(ours.getHeight(), 480U);
  EXPECT_TRUE(ours == theirs);
  EXPECT_GT(theirs.getMaxValue(), theirs.getMinValue());
}

// The programs ask the grabber for frames and convert them themselves, because acquire() ends the program when a frame
// cannot be delivered. The images must be those of acquire(), to the bit.
TEST(FireWireGrabber, OurConversionsAreThoseOfAcquire)
{
  const fs::path folder = test::emptyFolder();
  test::Json bus = test::chameleonBus();
  bus["same_noise"] = true;
  for (const std::string coding : {"mono8", "mono16", "raw8", "raw16", "yuv411", "yuv422", "yuv444", "rgb8"}) {
    bus["coding"] = coding;
    const test::Outcome outcome = runInside("SameImages", bus, folder);
    EXPECT_EQ(outcome.status, 0) << coding << "\n" << outcome.out << outcome.err;
  }
}
#endif
