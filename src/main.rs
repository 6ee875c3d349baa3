use fixpath::units::*; use fixpath::measure::*;
fn main(){
    let args: Vec<String> = std::env::args().skip(1).collect();
    let d = rotation::ROTATION.values(&args[1..]).unwrap().build().unwrap();
    if args[0]=="t" { print!("{}", d.netlist.to_text()); }
    println!("{:#?}", d.netlist.counts());
    let i = Inputs{sampler: if args[0]=="h" {Sampler::Hard} else {Sampler::Lit}, samples: 1_000_000, seed: 1};
    let r = measure(&[&d], &i, &|_|()).unwrap();
    for f in &r[0].figures { println!("{:10} {:10} max {:.3e} ({:?} ulp) mean {:.3e} bias {:.2e} rms {:.2e} p99 {:.2e} {:?}", f.quantity, f.basis.name(), f.max, f.max_ulp, f.mean, f.bias, f.rms, f.p99, f.witness.as_ref().map(|w|&w.words)); }
    println!("{:?} {:?}", r[0].overflows, r[0].speed);
    let b = BoundCheck::new(&d).unwrap(); println!("{:?} seen {:?} holds {}", b, b.seen(&r[0]), b.holds(&r[0]));
    for t in &d.tabulated { println!("{:?}", table_figures(t).unwrap()); }
}
