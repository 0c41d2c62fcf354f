// JTS: the argument is union or buffer. It has no sums.
//
// union: OverlayNGRobust.union of one set after the other, in doubles; if that fails, JTS snaps
// with a tolerance of 1e-12 of the size, up to five times with ten times as much, then rounds to
// a grid: in all less than 1e-7. buffer: round joins and caps, 16 segments for a quarter of a
// circle. Before, JTS takes shallow bends away, up to a hundredth of the radius
// (BufferParameters.DEFAULT_SIMPLIFY_FACTOR). Polygons for arcs miss 1 - cos(pi / 64) = 0.0012.
// Together less than 0.0125 of the radius. If that fails, JTS rounds to 12 digits, then to fewer.
import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.JTSVersion;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;

public final class Adapter {
  private static final GeometryFactory FACTORY = new GeometryFactory();
  private static final int QUARTER = 16;

  private static final class Skipped extends RuntimeException {
    Skipped(String reason) {
      super(reason);
    }
  }

  private static Coordinate[] line(JsonArray ring, boolean closed) {
    List<Coordinate> points = new ArrayList<>();
    for (JsonElement each : ring) {
      JsonArray point = each.getAsJsonArray();
      points.add(new Coordinate(point.get(0).getAsDouble(), point.get(1).getAsDouble()));
    }
    if (closed) points.add(points.get(0).copy());
    return points.toArray(new Coordinate[0]);
  }

  private static LinearRing ring(JsonElement value) {
    return FACTORY.createLinearRing(line(value.getAsJsonArray(), true));
  }

  private static Geometry area(JsonObject set) {
    List<Polygon> parts = new ArrayList<>();
    for (JsonElement each : set.getAsJsonArray("polygons")) {
      JsonObject polygon = each.getAsJsonObject();
      if (polygon.getAsJsonArray("outer").size() < 3) throw new Skipped("no points or segments");
      List<LinearRing> holes = new ArrayList<>();
      for (JsonElement hole : polygon.getAsJsonArray("holes")) holes.add(ring(hole));
      parts.add(FACTORY.createPolygon(ring(polygon.get("outer")), holes.toArray(new LinearRing[0])));
    }
    if (parts.size() == 1) return parts.get(0);
    return FACTORY.createMultiPolygon(parts.toArray(new Polygon[0]));
  }

  private static Geometry shape(JsonObject set) {
    JsonArray polygons = set.getAsJsonArray("polygons");
    if (polygons.size() == 1) {
      JsonArray outer = polygons.get(0).getAsJsonObject().getAsJsonArray("outer");
      if (outer.size() == 1) return FACTORY.createPoint(line(outer, false)[0]);
      if (outer.size() == 2) return FACTORY.createLineString(line(outer, false));
    }
    return area(set);
  }

  private static List<double[]> points(LinearRing ring) {
    List<double[]> found = new ArrayList<>();
    Coordinate[] all = ring.getCoordinates();
    for (int i = 0; i + 1 < all.length; i++) found.add(new double[] {all[i].x, all[i].y});
    return found;
  }

  private static JsonArray polygons(Geometry geometry) {
    Gson gson = new Gson();
    JsonArray found = new JsonArray();
    for (int i = 0; i < geometry.getNumGeometries(); i++) {
      if (!(geometry.getGeometryN(i) instanceof Polygon part) || part.isEmpty()) continue;
      JsonArray holes = new JsonArray();
      for (int k = 0; k < part.getNumInteriorRing(); k++) {
        holes.add(gson.toJsonTree(points(part.getInteriorRingN(k))));
      }
      JsonObject polygon = new JsonObject();
      polygon.add("outer", gson.toJsonTree(points(part.getExteriorRing())));
      polygon.add("holes", holes);
      found.add(polygon);
    }
    return found;
  }

  private static Geometry united(JsonArray sets) {
    Geometry found = null;
    for (JsonElement each : sets) {
      Geometry next = area(each.getAsJsonObject());
      found = found == null ? next : OverlayNGRobust.overlay(found, next, OverlayNG.UNION);
    }
    return found;
  }

  private static Geometry lines(JsonArray lines) {
    List<Geometry> parts = new ArrayList<>();
    for (JsonElement each : lines) {
      Coordinate[] points = line(each.getAsJsonArray(), false);
      parts.add(points.length == 1 ? FACTORY.createPoint(points[0])
                                   : FACTORY.createLineString(points));
    }
    return FACTORY.buildGeometry(parts);
  }

  private static BufferParameters how(JsonObject request) {
    BufferParameters how = new BufferParameters(QUARTER);
    String join = request.has("join") ? request.get("join").getAsString() : "round";
    String cap = request.has("cap") ? request.get("cap").getAsString() : "round";
    if (join.equals("mitre")) how.setJoinStyle(BufferParameters.JOIN_MITRE);
    if (join.equals("bevel")) how.setJoinStyle(BufferParameters.JOIN_BEVEL);
    if (request.has("limit")) how.setMitreLimit(request.get("limit").getAsDouble());
    if (cap.equals("flat")) how.setEndCapStyle(BufferParameters.CAP_FLAT);
    if (cap.equals("square")) how.setEndCapStyle(BufferParameters.CAP_SQUARE);
    return how;
  }

  private static Geometry grown(JsonObject request) {
    JsonObject set = request.getAsJsonObject("P");
    Geometry given = set.has("lines") ? lines(set.getAsJsonArray("lines")) : shape(set);
    return BufferOp.bufferOp(given, request.get("radius").getAsDouble(), how(request));
  }

  private static JsonObject hello(boolean union) {
    String tolerance =
        union ? "{\"relative\":\"1e-7\"}" : "{\"relative\":\"1e-7\",\"radius\":\"0.0125\"}";
    String more = union ? "\"union\"" : "\"point\",\"segment\",\"offset\",\"inset\",\"line-offset\","
            + "\"join-mitre\",\"join-bevel\",\"cap-flat\",\"cap-square\"";
    String text =
        "{\"protocol\":\"adapter-v1\",\"name\":\"" + (union ? "jts" : "jts-buffer")
            + "\",\"version\":\"" + JTSVersion.CURRENT_VERSION
            + "\",\"language\":\"Java\",\"arithmetic\":\"float64\",\"numbers\":\"double\","
            + "\"tolerance\":" + tolerance + ",\"sum\":\"none\",\"capabilities\":[\"plane\","
            + "\"non-convex\",\"holes\",\"components\",\"touching\",\"empty\"," + more + "]}";
    return JsonParser.parseString(text).getAsJsonObject();
  }

  private static JsonObject answer(JsonObject request, boolean union) {
    JsonObject answer = new JsonObject();
    String verb = request.get("verb").getAsString();
    if (verb.equals("hello")) {
      answer = hello(union);
    } else if (verb.equals("load")) {
      request.getAsJsonObject("Q").getAsJsonArray("polygons");
    } else if (verb.equals("union") && union) {
      answer.add("polygons", polygons(united(request.getAsJsonArray("sets"))));
    } else if (verb.equals("offset") && !union) {
      answer.add("polygons", polygons(grown(request)));
    } else if (!verb.equals("stop")) {
      throw new Skipped("no such verb here");
    }
    answer.addProperty("status", "result");
    return answer;
  }

  public static void main(String[] arguments) throws Exception {
    boolean union = arguments[0].equals("union");
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    BufferedReader in =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = in.readLine(); line != null; line = in.readLine()) {
      JsonObject answer = new JsonObject();
      JsonElement seq = null;
      boolean stop = false;
      try {
        JsonObject request = JsonParser.parseString(line).getAsJsonObject();
        seq = request.get("seq");
        answer = answer(request, union);
        stop = request.get("verb").getAsString().equals("stop");
      } catch (RuntimeException | StackOverflowError error) {
        answer.addProperty("status", error instanceof Skipped ? "skipped" : "errored");
        answer.addProperty("reason", String.valueOf(error));
      }
      answer.add("seq", seq);
      out.println(new Gson().newBuilder().serializeNulls().create().toJson(answer));
      if (stop) return;
    }
  }
}
