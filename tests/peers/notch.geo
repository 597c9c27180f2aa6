// Block with a V notch across its top.
DefineConstant[ size = 0.04, layers = 0, first_height = 1e-4, growth = 1.2, angle = 20 ];
depth = 0.5;
half = depth * Tan(angle / 2 * Pi / 180);
walls[] = {};
px[] = {-1, -1, -half, 0, half, 1, 1};
pz[] = {0, 1, 1, 1 - depth, 1, 1, 0};
y0 = 0;
y1 = 1;
Include "prism.geo";
Include "layers.geo";
