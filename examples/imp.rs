fn main(){ let a:Vec<String>=std::env::args().collect(); let t=std::fs::read_to_string(&a[1]).unwrap(); std::fs::write(&a[2], rayscope::peer::import(&t).unwrap()).unwrap(); }
