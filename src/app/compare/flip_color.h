// app/compare: the colour spaces of FLIP. Light is linear Rec.709; XYZ is divided by its white, so
// that white is (1, 1, 1) and no white point has to be carried along.
#pragma once

#include "core/math/vec.h"

namespace alhazen {

// XYZ relative to the white, in r, g, b.
Rgbd xyz_of_light(Rgbd light);
Rgbd light_of_xyz(Rgbd xyz);

// Opponent colours that are linear in light, so that filters may be applied to them: Y_y, C_x, C_z
// of Zhang and Wandell, "A Spatial Extension of CIELAB for Digital Color Image Reproduction", 1997.
Rgbd ycxcz_of_xyz(Rgbd xyz);
Rgbd xyz_of_ycxcz(Rgbd ycxcz);

// CIE 1976 L*, a*, b*, in r, g, b.
Rgbd lab_of_xyz(Rgbd xyz);
// Colours look less colourful where it is dark (Hunt 1952): a* and b* times 0.01 L*.
Rgbd hunt_adjusted(Rgbd lab);
// |L1 - L2| + |(a, b)1 - (a, b)2|, for large differences (Abasi, Amani Tehran and Fairchild,
// "Distance Metrics for Very Large Color Differences", 2020).
double hyab(Rgbd lab_1, Rgbd lab_2);

}  // namespace alhazen
