// Written by hand, to say the same as pov_reflection_metallic.scn.
#version 3.7;
global_settings { assumed_gamma 1  max_trace_level 17  adc_bailout 0 }
camera { location <0.3, 1.1, -4>  up y*3/4  right x  angle 50  look_at <0, 0.1, 0> }
background { rgb <0.2, 0.3, 0.45> }
light_source { <-3, 5, -4> rgb <1, 0.95, 0.9> }
plane { y, -0.9
  texture {
    pigment { checker rgb 0.9, rgb <0.25, 0.2, 0.2> scale 0.61 translate <0.11, 0.13, 0.07> }
    finish { diffuse 0.7 }
  }
}
sphere { <-0.1, 0, 0.2>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { reflection { 0.6 metallic } } }
