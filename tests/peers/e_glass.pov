// e_glass: refracting CSG lens, sphere and cube, ior 1.5, over a plain floor, 12 levels
// written by gen_scenes.py; do not edit
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 adc_bailout 0.00392156862745098 }
background { rgb <0.2,0.3,0.5> }
camera { perspective location <0.0,2.6,-7.5> direction <0.0,-0.2210590306428248,0.97526042930658>
  right <-0.9326153163099972,0.0,0.0> up <0.0,0.6821571103217848,0.15462227833960457> }
light_source { <6.0,10.0,-8.0> rgb <0.7,0.7,0.7> }
light_source { <-8.0,7.0,-3.0> rgb <0.4,0.4,0.4> }
#declare MAT_glass = material { texture { pigment { rgbt <1.0,1.0,1.0,0.85> } finish { ambient 0.0 diffuse 0.1 phong 0.6 phong_size 80 reflection 0.15 } } interior { ior 1.5 } }
#declare MAT_floor = material { texture { pigment { rgbt <0.9,0.9,0.9,0.0> } finish { ambient 0.1 diffuse 0.65 phong 0.0 phong_size 40 } } }
#declare MAT_red = material { texture { pigment { rgbt <0.9,0.2,0.15,0.0> } finish { ambient 0.1 diffuse 0.65 phong 0.5 phong_size 40 } } }
plane { <0.0,1.0,0.0>, -0.001 material { MAT_floor } }
intersection { 
  sphere { <0.0,0.0,-1.0>, 1.4 }
  sphere { <0.0,0.0,1.0>, 1.4 }
 material { MAT_glass } matrix <0.9829824531467901,0.0,-0.6882917236212552, 0.0,1.2,0.0, 0.6882917236212552,0.0,0.9829824531467901, 0.0,1.25,-0.5> }
sphere { <-2.3,1.0,0.3>, 1.0 material { MAT_glass } }
box { <-0.8,-0.8,-0.8>, <0.8,0.8,0.8> material { MAT_glass } matrix <0.882947592858927,0.0,-0.4694715627858908, 0.0,1.0,0.0, 0.4694715627858908,0.0,0.882947592858927, 2.3,0.85,0.4> }
sphere { <0.6,0.6,3.0>, 0.6 material { MAT_red } }
