package tompkins.measure;

import java.util.List;
import org.joml.Vector2dc;
import tompkins.trace.Frame;

/**
 * Something that is drawn over a picture, in pixels of it.
 *
 * @param kind what it is
 * @param lines each from point to point
 * @param dots points that are marked by a dot
 * @param rings points that are marked by a ring
 * @param labels what is written, and where
 */
public record OverlayDrawing(
        OverlayKind kind,
        List<List<Vector2dc>> lines,
        List<Vector2dc> dots,
        List<Vector2dc> rings,
        List<Label> labels) {

    /**
     * What is written at a position.
     *
     * @param text a name, a Doppler factor, or an angle in degrees
     * @param frame the frame in which the angle is measured; null if it is not an angle
     * @param position where
     * @param corners of a box around what it names and should not cover; empty if there is none, or if it is large
     */
    public record Label(String text, Frame frame, Vector2dc position, List<Vector2dc> corners) {

        /** What may be written at its position. */
        Label(String text, Frame frame, Vector2dc position) {
            this(text, frame, position, List.of());
        }
    }
}
