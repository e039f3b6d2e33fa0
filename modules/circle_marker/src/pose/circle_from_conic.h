#ifndef VP_CIRCLE_FROM_CONIC_H
#define VP_CIRCLE_FROM_CONIC_H

#include <array>
#include <optional>

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker
{
/*!
  Position of a circle: its centre, metres, and its unit normal pointing away from the camera (normal . center > 0),
  both in the camera frame.
*/
struct CirclePosition
{
  Eigen::Vector3d center;
  Eigen::Vector3d normal;
};

/*!
  The two circles of a given radius on the cone whose section at z = 1 is the ellipse x^T Q x = 0.
  Returns nothing if Q is not the image of a circle in front of the camera.
*/
std::optional<std::array<CirclePosition, 2>> circlesFromConic(const Eigen::Matrix3d &Q, double radius);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
