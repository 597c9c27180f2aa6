// L step: three unit cubes, one before and one below that at the corner.
DefineConstant[ size = 0.06, layers = 0, first_height = 1e-4, growth = 1.2 ];
walls[] = {};
px[] = {0, 0, 1, 1, 2, 2};
pz[] = {0, 2, 2, 1, 1, 0};
y0 = 0;
y1 = 1;
Include "prism.geo";
Include "layers.geo";
