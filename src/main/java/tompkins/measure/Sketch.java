package tompkins.measure;

import java.util.List;
import org.joml.Vector2dc;

/**
 * Where in a picture something was measured, in pixels of it.
 *
 * @param points single points
 * @param lines each from point to point
 */
public record Sketch(List<Vector2dc> points, List<List<Vector2dc>> lines) {

    /** Nothing. */
    public static final Sketch EMPTY = new Sketch(List.of(), List.of());

    /** Keeps copies. */
    public Sketch {
        points = List.copyOf(points);
        lines = List.copyOf(lines);
    }
}
