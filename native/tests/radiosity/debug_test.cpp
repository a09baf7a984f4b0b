#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#pragma GCC diagnostic ignored "-Wconversion"
#include <gtest/gtest.h>
#include "support/test_scenes.h"
#include "radiosity/link_estimate.h"
namespace gg::test {
static void summary(Prepared& p, float q, const char* what, double emitted) {
    auto s = p.solve(q);
    const auto& h = s->hierarchy; const size_t n_inst = p.scene.instances.size();
    std::vector<double> own(h.nodes().size()), near(h.nodes().size());
    double direct = 0;
    for (auto&l : s->links) { const Node&r=h[l.receiver]; const Node&t=h[l.sender]; double f=l.form_factor*l.visibility; if (is_cluster(t)&&!l.near) f*=s->lighting.area(l.sender)/4; 
       if (t.kind==NodeKind::kLamp) { direct += f*luminance(t.emission)*(is_cluster(r)? s->lighting.area(l.receiver)/4 : r.area); continue; }
       if(is_cluster(r)&&!l.near) f/=4; (l.near?near:own)[l.receiver]+=f; }
    std::vector<double> ow(n_inst),nr(n_inst),ar(n_inst),e(n_inst); std::vector<int> el(n_inst), cl(n_inst); double absorbed=0, lo=1e9,hi=0;
    for (NodeId id=0; id<h.nodes().size(); ++id) { const Node& n=h[id]; if (n.parent!=kNone) { own[id]+=own[n.parent]; near[id]+=near[n.parent]; }
        if(!is_surface(n)||n.child_count||n.kind==NodeKind::kInstances) continue;
        double A=s->lighting.area(id), E=luminance(s->lighting.irradiance(id)); absorbed+=A*E*(1-luminance(n.reflectance));
        if (n.kind==NodeKind::kElement&&n.back) continue;
        lo=std::min(lo,E); hi=std::max(hi,E);
        int i=n.instance; ow[i]+=A*own[id]; nr[i]+=A*near[id]; ar[i]+=A; e[i]+=A*E; (n.kind==NodeKind::kElement?el:cl)[i]++; }
    printf("%s q %.4f E %.3f..%.3f absorbed/emitted %.4f direct %.4f links %zu nodes %zu %s\n", what, q, lo, hi, absorbed/emitted, direct/emitted, s->links.size(), h.nodes().size(), p.statistics.json().substr(0,90).c_str());
    for (size_t i=0;i<n_inst;i++) printf("   %-12s E %.4f cover far %.4f near %.4f elements %d clusters %d\n", p.scene.instances[i].name.c_str(), e[i]/ar[i], ow[i]/ar[i], nr[i]/ar[i], el[i], cl[i]);
}
TEST(Debug, sweep) {
  for (float q : {0.02f, 0.005f}) for (int furnished=0; furnished<3; ++furnished) {
    SceneBuilder builder;
    const std::uint32_t m = builder.material(Rgb(0.5f), Rgb(furnished==2?0:1/kPi));
    builder.box({0, 0, 0}, {4, 3, 2.5F}, {m, m, m, m, m, m}, true);
    if (furnished) { builder.solid({1, 1, 0.2F}, {1.7F, 1.8F, 0.9F}, m);
        builder.sphere({2.8F, 1.4F, 0.8F}, 0.5F, 24, m, false); }
    if (furnished==2) builder.area_light({2, 1.5F, 2.4F}, {0, 0, -1}, 1, Rgb(100));
    Prepared p(builder.description);
    summary(p, q, furnished==0?"empty furnace":furnished==1?"furnace":"lamp", furnished==2?78.54: furnished==1 ? 59+6.35:59);
  }
}
}
namespace gg::test {
TEST(Debug, sphere) {
    SceneBuilder builder;
    const std::uint32_t m = builder.material(Rgb(0.5f), Rgb(1/kPi));
    builder.box({0, 0, 0}, {4, 3, 2.5F}, {m, m, m, m, m, m}, true);
    builder.sphere({2.8F, 1.4F, 0.8F}, 0.5F, 24, m, false);
    Prepared p(builder.description);
    summary(p, .005f, "sphere", 1);
    auto s = p.solve(0.005F); const auto& h = s->hierarchy;
    int shown=0;
    for (NodeId id=0; id<h.nodes().size() && shown<12; ++id) { const Node& n=h[id]; if (n.kind>NodeKind::kElement||n.child_count||n.instance!=6||id%97) continue; shown++;
       printf("node %u kind %d n %.2f %.2f %.2f E %.3f\n", id, (int)n.kind, n.normal.x,n.normal.y,n.normal.z, luminance(s->lighting.irradiance(id)));
       for (NodeId a=id; a!=kNone; a=h[a].parent) { double f[4]={}, dark[4]={}; int c=0, z=0; for(auto&l:s->links) if(l.receiver==a) { ++c; int k=l.near?3:(int)h[l.sender].kind; f[k]+=l.form_factor*l.visibility*luminance(s->lighting.radiosity(l.sender)); dark[k]+=l.form_factor*(1-l.visibility); z+=l.visibility==0;}
           Rgb e = h[a].kind==NodeKind::kElement? s->lighting.irradiance(a): evaluate(s->lighting.received(a), n.normal);
           printf("    level kind %d radius %.2f links %d dark %d  F cluster %.3f elem %.3f near %.3f unseen %.3f %.3f total so far E(n) %.3f\n", (int)h[a].kind, h[a].radius, c, z, f[0]+f[1], f[2], f[3], dark[1], dark[2], luminance(e)); }
    }
}}
