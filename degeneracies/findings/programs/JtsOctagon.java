// JTS: buffer of a frame whose octagonal hole is narrower than the distance.
// java -cp jts-core-1.20.0.jar JtsOctagon.java
import org.locationtech.jts.JTSVersion;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.io.WKTReader;

public final class JtsOctagon {
  public static void main(String[] arguments) throws Exception {
    GeometryFactory factory = new GeometryFactory();
    Geometry frame =
        new WKTReader(factory)
            .read(
                "POLYGON ((-9 -9, 9 -9, 9 9, -9 9, -9 -9),"
                    + " (2 2, 3 0, 2 -2, 0 -3, -2 -2, -3 0, -2 2, 0 3, 2 2))");
    // The middle of the hole, (0, 0), is 6 / sqrt(5) = 2.683 from its sides.
    Geometry grown = frame.buffer(2.9);
    boolean inside = grown.contains(new WKTReader(factory).read("POINT (0 0)"));
    System.out.println("JTS " + JTSVersion.CURRENT_VERSION + "; valid: " + frame.isValid());
    System.out.println("rings of the buffer: " + grown.getBoundary().getNumGeometries());
    System.out.println("x = (0, 0) in the buffer: " + (inside ? "in" : "out") + ", in truth: in");
    System.exit(inside ? 0 : 1);
  }
}
