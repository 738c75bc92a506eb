// Written by hand, to say the same as camera_perspective.scn.
#version 3.7;
global_settings { assumed_gamma 1  max_trace_level 17  adc_bailout 0 }
camera { location <1.5, 1.7, -3>  up y*3/4  right x  angle 65  sky <0.4, 1, 0.2>  look_at <0.1, -0.2, 0.4> }
background { rgb <0.2, 0.3, 0.45> }
light_source { <-3, 5, -4> rgb <3, 2.9, 2.7> }
plane { y, -0.7
  texture {
    pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> scale 0.83 translate <0.13, 0.21, 0.17> }
    finish { ambient 0 diffuse 1/pi }
  }
}
sphere { <0.4, 0.1, 0.5>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } finish { ambient 0 diffuse 1/pi } }
