SetFactory("OpenCASCADE");
Box(1) = {0,0,0,1,1,1};
Box(2) = {1,0,0,1,1,1};
Coherence;
Physical Volume("soft", 11) = {1};
Physical Volume("hard", 5) = {2};
Mesh.MeshSizeMin=0.8; Mesh.MeshSizeMax=1;
