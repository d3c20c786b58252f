#define PART 2  // see microscope.frag
