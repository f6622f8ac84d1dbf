// The scene of Fig. 1(a), and with Declare=Moving=1 that of Fig. 1(b), for a comparison of speed.
#version 3.7;
global_settings { assumed_gamma 1 }

// Darker, so that the file holds highlights that are brighter than white.
#declare Exposure = 0.4;
background { color rgb Exposure * <0.5, 0.5, 1> }

#declare HalfWidth = tan(radians(20.03066570511592 / 2));
#declare HalfHeight = tan(radians(15.097852663761984 / 2));

#ifdef (Moving)
  // All rays of Fig. 1(b) leave one event, so that a scene at rest looks as through a camera at rest whose rays go where
  // aberration says: from a tiny mesh, along normals. They are right at its corners. One row of cells more on each side
  // is for what antialiasing takes beyond the edges.
  #declare Columns = 32;
  #declare Rows = 24;
  #declare Size = 0.001;
  #declare Velocity = <0.2, -0.1, 0.97>;
  #declare Gamma = 1 / sqrt(1 - vdot(Velocity, Velocity));

  #macro Corner(I, J)
    #local D = vnormalize(<(2 * I / Columns - 1) * HalfWidth, (2 * J / Rows - 1) * HalfHeight, 1>);
    Size * <I / Columns - 0.5, J / Rows - 0.5, 0>,
    D + Gamma * Velocity * (Gamma * vdot(Velocity, D) / (Gamma + 1) - 1)
  #end

  // POV-Ray looks up the upper left corner of a pixel, and not its middle.
  #macro Place(I, J) <I / Columns - 0.5 / image_width, J / Rows + 0.5 / image_height> #end

  #macro Half(I, J, Step)
    smooth_triangle {
      Corner(I, J), Corner(I + Step, J), Corner(I, J + Step)
      uv_vectors Place(I, J), Place(I + Step, J), Place(I, J + Step)
    }
  #end

  camera {
    mesh_camera {
      1 3
      mesh {
        #for (I, -1, Columns)
          #for (J, -1, Rows)
            Half(I, J, 1)
            Half(I + 1, J + 1, -1)
          #end
        #end
      }
      smooth
    }
  }
#else
  camera {
    location 0
    right 2 * HalfWidth * x
    up 2 * HalfHeight * y
    direction z
  }
#end

light_source { <100, 300, -500> color rgb Exposure }

#declare Shine = finish { ambient 0.2 * Exposure diffuse 1 phong 1 phong_size 40 }

plane {
  y, -1
  pigment { checker color rgb 1 color rgb 0.5 }
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
