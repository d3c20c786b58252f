#define PART 1  // see microscope.frag
