// Two plates, one above the other, with a gap between them.
DefineConstant[ size = 0.05, layers = 0, first_height = 1e-4, growth = 1.2, gap = 0.03 ];
thickness = 0.3;
walls[] = {};
y0 = 0;
y1 = 1;
px[] = {0, 0, 1, 1};
pz[] = {0, thickness, thickness, 0};
Include "prism.geo";
pz[] = {thickness + gap, 2 * thickness + gap, 2 * thickness + gap, thickness + gap};
Include "prism.geo";
Include "layers.geo";
