// Unit cube; structured = 1: of right isosceles triangles.
DefineConstant[ size = 0.05, layers = 0, first_height = 1e-4, growth = 1.2, structured = 0 ];
walls[] = {};
px[] = {0, 0, 1, 1};
pz[] = {0, 1, 1, 0};
y0 = 0;
y1 = 1;
Include "prism.geo";
If (structured)
  Transfinite Curve{:} = Round(1 / size) + 1;
  Transfinite Surface{:};
EndIf
Include "layers.geo";
