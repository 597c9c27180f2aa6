// Closed prism over the polygon (px[], pz[]), clockwise as x points right and z up, from y = y0 to y1. Its surfaces
// are appended to walls[].
n = #px[];
p = newp;
For i In {0 : n - 1}
  Point(p + i) = {px[i], y0, pz[i], size};
  Point(p + n + i) = {px[i], y1, pz[i], size};
EndFor
l = newl;
For i In {0 : n - 1}
  j = (i + 1) % n;
  Line(l + i) = {p + i, p + j};
  Line(l + n + i) = {p + n + i, p + n + j};
  Line(l + 2 * n + i) = {p + i, p + n + i};
EndFor
s = news;
near[] = {};
far[] = {};
For i In {0 : n - 1}
  j = (i + 1) % n;
  near[] += {-(l + n - 1 - i)};
  far[] += {l + n + i};
  Curve Loop(s + i) = {l + i, l + 2 * n + j, -(l + n + i), -(l + 2 * n + i)};
  Plane Surface(s + i) = {s + i};
EndFor
Curve Loop(s + n) = near[];
Plane Surface(s + n) = {s + n};
Curve Loop(s + n + 1) = far[];
Plane Surface(s + n + 1) = {s + n + 1};
For i In {0 : n + 1}
  walls[] += {s + i};
EndFor
