package tompkins.world;

import java.util.List;
import org.joml.Vector3dc;
import tompkins.light.RestingLight;
import tompkins.light.Sightline;
import tompkins.ray.Hit;
import tompkins.search.LampShadows;
import tompkins.search.LampTrack;

/**
 * A light source that rests in a frame, and what is prepared for its shadows. Lights that have no place belong to the
 * scene frame.
 *
 * @param light the source, in the coordinates in which the tracer works
 * @param frame the number of its frame
 * @param properTimeZero when its own time is 0, in the time of that frame
 * @param grid what it sees of what rests with it, or null if that is not prepared
 * @param tracks its way past what rests in each frame, null where that is not prepared; empty if it is nowhere
 */
public record Lamp(RestingLight light, int frame, double properTimeZero, LampShadows grid, List<LampTrack> tracks) {

    /** A lamp for whose shadows nothing is prepared. */
    public Lamp(RestingLight light, int frame, double properTimeZero) {
        this(light, frame, properTimeZero, null, List.of());
    }

    /** Where it is, or null if it has no place. */
    Vector3dc position() {
        return light.position();
    }

    /** What it sees of what rests with it, for the next shadow ray; null if the tree is to answer. */
    public LampShadows shadows() {
        return grid == null ? null : grid.gridOrNull();
    }

    /** Its way past what rests in a frame, or null if that is not prepared. */
    LampTrack track(int other) {
        return tracks.isEmpty() ? null : tracks.get(other);
    }

    /** Finds the way to it from a hit on something that rests with it. */
    public void find(Hit hit, Sightline sight) {
        Vector3dc at = light.position();
        sight.set(at.x() - hit.x, at.y() - hit.y, at.z() - hit.z, hit.time - properTimeZero);
    }
}
