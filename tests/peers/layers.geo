// Layers of prisms on walls[], whose normals point into the fluid: heights that grow by a constant ratio, at each point
// along the mean of the normals of its triangles. With layers = 0 the walls are all there is.
If (layers > 0)
  counts[] = {};
  heights[] = {};
  height = 0;
  For i In {0 : layers - 1}
    height += first_height * growth ^ i;
    counts[] += {1};
    heights[] += {height};
  EndFor
  Extrude { Surface{ walls[] }; Layers{ counts[], heights[] }; Using Index[0]; Recombine; }
EndIf
