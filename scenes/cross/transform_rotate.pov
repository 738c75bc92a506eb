// Written by hand, to say the same as transform_rotate.scn.
#version 3.7;
global_settings { assumed_gamma 1  max_trace_level 17  adc_bailout 0 }
camera { location <0.3, 1.1, -4>  up y*3/4  right x  angle 50  look_at <0, 0.1, 0> }
background { rgb <0.2, 0.3, 0.45> }
light_source { <-3, 5, -4> rgb <3, 2.9, 2.7> }
#declare Clay = texture { pigment { rgb <0.8, 0.5, 0.3> } finish { ambient 0 diffuse 1/pi } }
#declare Brick = box { <-0.3, -0.2, -0.1>, <0.3, 0.4, 0.25> texture { Clay } }
object { Brick rotate 35*x translate <-1.3, 0.4, 0> }
object { Brick rotate 35*y translate <-0.4, 0.4, 0> }
object { Brick rotate 35*z translate <0.6, 0.4, 0> }
object { Brick rotate <20, 50, -70> translate <-0.5, -0.6, 0> }
object { Brick rotate -70*z rotate 50*y rotate 20*x translate <0.7, -0.6, 0> }
