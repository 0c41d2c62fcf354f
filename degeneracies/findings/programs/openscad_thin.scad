// OpenSCAD: minkowski(). openscad errored: errored
// openscad -o openscad_thin.svg openscad_thin.scad; echo $?
module p() {
  polygon([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
    [[0, 1, 2]]);
}
module q() {
  polygon([[1.0, 28399342975174.0], [2.0, 0.0], [0.0, 56798887280640.0]],
    [[0, 1, 2]]);
}
module total() {
  minkowski() {
    p();
    q();
  }
}
total();
