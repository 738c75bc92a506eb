// Written by hand, to say the same as transform_groups.scn.
#version 3.7;
global_settings { assumed_gamma 1  max_trace_level 17  adc_bailout 0 }
camera { location <0.3, 1.1, -4>  up y*3/4  right x  angle 50  look_at <0, 0.1, 0> }
background { rgb <0.2, 0.3, 0.45> }
light_source { <-3, 5, -4> rgb <3, 2.9, 2.7> }
#declare Arm = union {
  box { <0, -0.1, -0.1>, <0.8, 0.1, 0.1> }
  union {
    sphere { 0, 0.2 scale <1, 1.5, 1> }
    box { <0, -0.05, -0.05>, <0.5, 0.05, 0.05> }
    rotate 50*z
    translate 0.8*x
  }
  texture { pigment { rgb <0.3, 0.6, 0.8> } finish { ambient 0 diffuse 1/pi } }
}
object { Arm rotate 20*z translate <-1.2, 0.3, 0> }
union {
  object { Arm scale 0.7 rotate 60*y }
  object { Arm rotate 90*z translate <0.1, 0.2, 0> }
  rotate 25*x
  translate <0.3, -0.6, 0>
}
