#define PART 0  // see microscope.frag
