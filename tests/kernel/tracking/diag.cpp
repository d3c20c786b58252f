#include <cstdio>
#include <cstdlib>
#include <string>
#include "tracking/sources/synthetic_source.hpp"
#include "tracking/synthetic/bodies.hpp"
#include "tracking/synthetic/clips.hpp"
#include "tracking/bodies/rigid_fit.hpp"
using namespace rhexis; using namespace rhexis::tracking;
int main(int argc,char**argv){
  auto rig = synthetic::SyntheticRig::create(1).value();
  Rig solver = without_prism(rig);
  auto bodies = synthetic::standard_bodies();
  static auto clip = synthetic::make_clip(argv[1],1,bodies,rig.nominal).value();
  if (argc>3) { clip.hands=false; clip.glints=false; }
  synthetic::Film film; film.frames=2; film.seed=1;
  synthetic::Stage stage; stage.scene=[](double t, synthetic::Scene&s){scene_at(clip,t,s);};
  SpotSettings ss; if(argc>2) ss.level=std::atof(argv[2]);
  ImageSpots src(film_images(rig,stage,film).value(), ss);
  std::vector<CameraSpots> ex; src.next(ex);
  for(auto&e:ex) for(size_t b=0;b<bodies.size();++b) for(size_t m=0;m<4;++m){
    const Camera& cam=solver.cameras[e.camera];
    Vec3 seen=cam.pose.to_body(pose_at(clip,b,e.time_s).to_world(bodies[b].markers[m]));
    Vec2 im=sphere_image(cam.lens,seen,3.0); double area=sphere_area(cam.lens,seen,3.0);
    const Spot* best=nullptr; double d=1e9; for(auto&s:e.spots){double q=(s.at-im).norm(); if(q<d){d=q;best=&s;}}
    double r=std::sqrt(area/3.14159)+0.5;
    const auto& w=clip.worn[b][m];
    if(best&&d<15) std::printf("cam %d %-22s m%zu off %6.3f (%6.3f %6.3f) area ratio %.3f round %.3f peak %3.0f %s%s%s worn %.2f %.2f\n",e.camera,bodies[b].name.c_str(),m,d,(best->at-im).x(),(best->at-im).y(),best->area/(3.14159*r*r),best->roundness,best->peak,best->crowded?"crowded ":"",best->clipped?"clipped ":"",best->at_rim?"rim":"",w.cosine,w.left);
    else std::printf("cam %d %-22s m%zu none\n",e.camera,bodies[b].name.c_str(),m);
  }
}
