// Written by hand, to say the same as light_directional.scn.
#version 3.7;
global_settings { assumed_gamma 1  max_trace_level 17  adc_bailout 0 }
camera { location <0.3, 1.1, -4>  up y*3/4  right x  angle 50  look_at <0, 0.1, 0> }
background { rgb <0.2, 0.3, 0.45> }
light_source { -1000*<0.6, -1, 0.8> rgb <2.8, 2.7, 2.4> parallel point_at 0 }
#declare Matt = finish { ambient 0 diffuse 1/pi }
plane { y, -0.7 pigment { rgb 0.8 } finish { Matt } }
sphere { <0.4, 0.1, 0.5>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } finish { Matt } }
box { <-1.3, -0.7, 0>, <-0.6, 0.3, 0.6> pigment { rgb <0.3, 0.5, 0.7> } finish { Matt } }
