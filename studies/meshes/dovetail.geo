// A dovetail joint: the tongue (upper body) in its groove (lower body).
//
//            9────8
//            │    │              The shank is as wide as the mouth of the groove,
//   16──15   │    │   12──11     the foot wider. Both bodies have curves of their own
//    │   \ 5─┘    └─6 /   │      along the flanks and the bottom, divided alike, so that
//    │    \          /    │      every node of one face has its partner on the other.
//    │     \ 4────3 /     │
//   13────────────────────10
//
// gmsh -2 -format msh41 -o dovetail.msh dovetail.geo      (Gmsh 4.15.2; Mesh.Binary = 1 works as well)

h = 0.5;        // size of the elements
flank = 4;      // nodes on a flank
bottom = 6;     // nodes on the bottom

// tongue, counterclockwise
Point(3) = { 1.0, -1, 0, h};
Point(4) = {-1.0, -1, 0, h};
Point(5) = {-0.5,  0, 0, h};
Point(6) = { 0.5,  0, 0, h};
Point(8) = { 0.5,  1, 0, h};
Point(9) = {-0.5,  1, 0, h};
Line(1) = {4, 3};
Line(2) = {3, 6};
Line(3) = {6, 8};
Line(4) = {8, 9};
Line(5) = {9, 5};
Line(6) = {5, 4};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};

// groove, counterclockwise; 12, 17, 18, 15 lie where 6, 3, 4, 5 do
Point(10) = { 2.5, -2.5, 0, h};
Point(11) = { 2.5,  0, 0, h};
Point(12) = { 0.5,  0, 0, h};
Point(13) = {-2.5, -2.5, 0, h};
Point(15) = {-0.5,  0, 0, h};
Point(16) = {-2.5,  0, 0, h};
Point(17) = { 1.0, -1, 0, h};
Point(18) = {-1.0, -1, 0, h};
Line(11) = {13, 10};
Line(12) = {10, 11};
Line(13) = {11, 12};
Line(14) = {12, 17};
Line(15) = {17, 18};
Line(16) = {18, 15};
Line(17) = {15, 16};
Line(18) = {16, 13};
Curve Loop(2) = {11, 12, 13, 14, 15, 16, 17, 18};
Plane Surface(2) = {2};

// partners
Transfinite Curve {2, 6, 14, 16} = flank;
Transfinite Curve {1, 15} = bottom;

Physical Surface("tongue") = {1};
Physical Surface("groove") = {2};
Physical Curve("tongue-face") = {6, 1, 2};
Physical Curve("groove-face") = {14, 15, 16};
Physical Curve("tongue-top") = {4};
Physical Curve("tongue-sides") = {3, 5};
Physical Curve("groove-bottom") = {11};
Physical Curve("groove-free") = {12, 13, 17, 18};
