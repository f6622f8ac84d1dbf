// The scene of Fig. 1(a) for a comparison of speed.
#version 3.7;
global_settings { assumed_gamma 1 }
background { color rgb <0.5, 0.5, 1> }

#declare HalfWidth = tan(radians(20.03066570511592 / 2));
#declare HalfHeight = tan(radians(15.097852663761984 / 2));

camera {
  location 0
  right 2 * HalfWidth * x
  up 2 * HalfHeight * y
  direction z
}

light_source { <100, 300, -500> color rgb 1 }

#declare Shine = finish { ambient 0.2 diffuse 1 phong 1 phong_size 40 }

plane {
  y, -1
  pigment { checker color rgb 0.5 color rgb 1 }
  finish { Shine }
}

#macro Rod(From, To, Colour)
  cylinder { From, To, 0.02 pigment { color Colour } finish { Shine } }
#end

#for (I, 0, 3)
  #for (J, 0, 3)
    Rod(<I - 1.5, J - 1.5, -1>, <I - 1.5, J - 1.5, 10>, rgb <1, 0, 0>)
  #end
  #for (J, 0, 11)
    Rod(<-1.5, I - 1.5, J - 1>, <1.5, I - 1.5, J - 1>, rgb <0, 0, 1>)
    Rod(<I - 1.5, -1.5, J - 1>, <I - 1.5, 1.5, J - 1>, rgb <0, 1, 0>)
  #end
#end
