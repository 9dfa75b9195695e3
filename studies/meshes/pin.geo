// Half of a round pin in half of a plate with a hole of the same radius; the axis of symmetry is x = 0.
//
// The arcs become chords in the file. The study names the circle, so that sides and their refinements lie on it again.
//
// gmsh -2 -format msh41 -o pin.msh pin.geo      (Gmsh 4.15.2; Mesh.Binary = 1 works as well)

quarter = 7;    // nodes on a quarter of the hole, on either face
near = 0.26;    // size of the elements at the hole
far = 3.5;      // and at the rim of the plate

Point(1) = {0, 0, 0, near};

// pin
Point(2) = {0, -1, 0, near};
Point(3) = {1,  0, 0, near};
Point(4) = {0,  1, 0, near};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 2};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};

// plate; 12, 13, 14 lie where 2, 3, 4 do
Point(12) = {0, -1, 0, near};
Point(13) = {1,  0, 0, near};
Point(14) = {0,  1, 0, near};
Point(15) = {0, -10, 0, far};
Point(16) = {10, -10, 0, far};
Point(17) = {10, 10, 0, far};
Point(18) = {0, 10, 0, far};
Circle(11) = {12, 1, 13};
Circle(12) = {13, 1, 14};
Line(13) = {14, 18};
Line(14) = {18, 17};
Line(15) = {17, 16};
Line(16) = {16, 15};
Line(17) = {15, 12};
Curve Loop(2) = {11, 12, 13, 14, 15, 16, 17};
Plane Surface(2) = {2};

// partners
Transfinite Curve {1, 2, 11, 12} = quarter;

Physical Surface("pin") = {1};
Physical Surface("plate") = {2};
Physical Curve("pin-face") = {1, 2};
Physical Curve("plate-face") = {11, 12};
Physical Curve("pin-axis") = {3};
Physical Curve("plate-axis") = {13, 17};
Physical Curve("rim") = {14, 15, 16};
