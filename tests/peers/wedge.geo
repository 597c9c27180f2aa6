// Wedge with a sharp trailing edge: front face at x = 0, trailing edge at x = 1, span 2.
DefineConstant[ size = 0.03, layers = 0, first_height = 1e-5, growth = 1.2, angle = 10 ];
half = Tan(angle / 2 * Pi / 180);
walls[] = {};
px[] = {0, 1, 0};
pz[] = {half, 0, -half};
y0 = -1;
y1 = 1;
Include "prism.geo";
Include "layers.geo";
