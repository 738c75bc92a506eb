// Written by hand, to say the same as transform_stretch.scn.
#version 3.7;
global_settings { assumed_gamma 1  max_trace_level 17  adc_bailout 0 }
camera { location <0.3, 1.1, -4>  up y*3/4  right x  angle 50  look_at <0, 0.1, 0> }
background { rgb <0.2, 0.3, 0.45> }
light_source { <-3, 5, -4> rgb <3, 2.9, 2.7> }
#declare Clay = texture { pigment { rgb <0.8, 0.5, 0.3> } finish { ambient 0 diffuse 1/pi } }
sphere { 0, 0.4 texture { Clay } scale <1, 1.8, 0.6> rotate 25*z translate <-1.1, 0.2, 0> }
cone { -0.4*y, 0.5, <0.2, 0.5, 0>, 0 texture { Clay } scale <-1, 1, 2> translate <0, 0.1, 0.3> }
cylinder { -0.4*y, 0.4*y, 0.3 texture { Clay }
  matrix <1, 0, 0.3,  0.6, 1, 0,  0, 0, 1,  1, 0.2, 0> }
plane { y, 0 texture { Clay } rotate 8*x translate -0.8*y }
