package tompkins.spacetime;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The light of a medium, as an observer sees it who moves through it. In the rest frame of the medium the tangent of a
 * ray is (d, -n |d|) and the frequency is |d|; the observer sees it in the direction of the tangent in his rest frame.
 * So from his unit direction follow the direction d in the medium, its length L, and his frequency W in the same units.
 *
 * <p>With the proper velocity U of the observer in the medium along the unit vector m, the parts d1 along m and d2
 * across of his direction, and {@code a = 1 - (n - 1)(n + 1) U^2}:
 *
 * <pre>W = sqrt(d1^2 + a d2^2),   L = (gamma W - n U d1)/a,   d = d2 + m (gamma d1 - n U W)/a</pre>
 *
 * Ahead, where these differences lose digits, they are multiplied out; with these forms nothing cancels, up to gamma
 * 1e6 and more. Where a is below 0 the observer is faster than the light in the medium: he sees light within a cone
 * around his motion only, and there two things at once, light that he meets and light that he overtakes from behind.
 */
public final class LightInMedium {

    private final double index;
    private final double gamma;
    private final double speed;
    private final double wider;
    private final Vector3dc along;
    private final RelativeMotion observer;

    /**
     * The light for an observer.
     *
     * @param index refractive index of the medium
     * @param observer how his frame, the second, moves in the rest frame of the medium, the first
     */
    public LightInMedium(double index, RelativeMotion observer) {
        this.index = index;
        this.observer = observer;
        gamma = observer.gamma();
        Vector3dc proper = observer.inSecond();
        speed = proper.length();
        along = speed == 0 ? new Vector3d(0, 0, 1) : proper.div(speed, new Vector3d());
        wider = 1 - (index - 1) * (index + 1) * speed * speed;
    }

    /**
     * Light that an observer sees.
     *
     * @param direction unit direction of the ray in the rest frame of the medium, traced backwards
     * @param length of the tangent there, if it is 1 in the frame of the observer: radiance for him is less by its
     *     fourth power
     * @param frequency for the observer divided by that in the rest frame of the medium: below 0 if he overtakes the
     *     light and sees its last crest first
     */
    public record Seen(Vector3dc direction, double length, double frequency) {}

    /** Whether the observer rests in the medium. */
    public boolean isAtRest() {
        return speed == 0;
    }

    /** Whether the observer is not slower than the light in the medium. */
    public boolean isOutrun() {
        return wider <= 0;
    }

    /** The light that an observer meets in his unit look direction (dx, dy, dz); null if none comes. */
    public Seen met(double dx, double dy, double dz) {
        if (speed == 0) {
            return new Seen(turned(new Vector3d(dx, dy, dz)), 1, 1);
        }
        double ahead = along.dot(dx, dy, dz);
        Vector3d across = across(dx, dy, dz);
        double squaredAcross = across.lengthSquared();
        double scaled = scaledFrequency(ahead, squaredAcross);
        double length = length(ahead, squaredAcross, scaled);
        double part = ahead > 0
                ? (ahead * ahead - index * index * speed * speed * squaredAcross)
                        / (gamma * ahead + index * speed * scaled)
                : (gamma * ahead - index * speed * scaled) / wider;
        return Double.isNaN(length) ? null : seen(across, part, length, scaled / length);
    }

    private double scaledFrequency(double ahead, double squaredAcross) {
        return Math.sqrt(ahead * ahead + wider * squaredAcross);
    }

    /** Length in the medium of the tangent of the light that is met; NaN if there is none. */
    private double length(double ahead, double squaredAcross, double scaled) {
        if (ahead > 0) {
            return (ahead * ahead + gamma * gamma * squaredAcross) / (gamma * scaled + index * speed * ahead);
        }
        return wider > 0 ? (gamma * scaled - index * speed * ahead) / wider : Double.NaN;
    }

    /**
     * Time per unit length, in the frame of the observer, of the light that he meets who looks along the unit direction
     * (dx, dy, dz) of his frame; NaN if no light comes from there.
     */
    public double slowness(double dx, double dy, double dz) {
        double x = dy * along.z() - dz * along.y();
        double y = dz * along.x() - dx * along.z();
        double z = dx * along.y() - dy * along.x();
        double ahead = along.dot(dx, dy, dz);
        double squaredAcross = x * x + y * y + z * z;
        return slowness(length(ahead, squaredAcross, scaledFrequency(ahead, squaredAcross)));
    }

    /**
     * The light that an observer overtakes, in the same direction; null if there is none, as at all speeds below that
     * of light in the medium.
     */
    public Seen overtaken(Vector3dc look) {
        double ahead = look.dot(along);
        Vector3d across = across(look.x(), look.y(), look.z());
        double scaled = scaledFrequency(ahead, across.lengthSquared());
        if (!(wider < 0 && ahead > 0 && scaled >= 0)) {
            return null;
        }
        double length = -(index * speed * ahead + gamma * scaled) / wider;
        double part = (gamma * ahead + index * speed * scaled) / wider;
        return seen(across, part, length, -scaled / length);
    }

    private Vector3d across(double dx, double dy, double dz) {
        Vector3d normal = along.cross(dx, dy, dz, new Vector3d());
        return normal.cross(along);
    }

    private Seen seen(Vector3d across, double part, double length, double frequency) {
        return new Seen(turned(across.fma(part, along).div(length)), length, frequency);
    }

    private Vector3d turned(Vector3d direction) {
        return observer.turn().transform(direction);
    }

    /** Time per unit length, in the frame of the observer, of light whose tangent has a length in the medium. */
    public double slowness(double length) {
        return speed == 0 ? index : Math.sqrt(1 + (index - 1) * (index + 1) * length * length);
    }
}
