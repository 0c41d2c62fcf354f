// JTS: buffer. JtsBuffer.java "X" TRUTH SET DISTANCE: X is a point "x y", TRUTH what is right of
// it: in, out, or any where the call alone matters. The set is WKT.
import org.locationtech.jts.JTSVersion;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.io.WKTReader;

public final class JtsBuffer {
  public static void main(String[] given) throws Exception {
    WKTReader reader = new WKTReader();
    Geometry set = reader.read(given[2]);
    Geometry grown = set.buffer(Double.parseDouble(given[3]));
    boolean in = grown.contains(reader.read("POINT (" + given[0] + ")"));
    String found = in ? "in" : "out";
    System.out.println("JTS " + JTSVersion.CURRENT_VERSION + "; valid: " + set.isValid());
    System.out.println("rings of the buffer: " + grown.getBoundary().getNumGeometries());
    System.out.println(
        "x = (" + given[0] + ") in the buffer: " + found + ", in truth: " + given[1]);
    System.exit(given[1].equals("any") || given[1].equals(found) ? 0 : 1);
  }
}
