package tompkins.spacetime;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The change of frame as the paper writes it: with gamma from {@code 1 - beta^2} and {@code (gamma - 1)/beta^2}. */
public final class NaiveFrames implements FrameMethod {

    @Override
    public double gamma(Vector3dc beta) {
        return 1 / Math.sqrt(1 - beta.lengthSquared());
    }

    @Override
    public double gammaMinusOne(Vector3dc beta) {
        return gamma(beta) - 1;
    }

    @Override
    public Event event(Vector3dc beta, Event event) {
        double gamma = gamma(beta);
        Vector3d place = event.position();
        double stretch = (gamma - 1) / beta.lengthSquared() * place.dot(beta) + gamma * event.time();
        Vector3d moved = new Vector3d(beta).mul(stretch).add(place);
        return new Event(moved.x, moved.y, moved.z, gamma * (event.time() + place.dot(beta)));
    }

    @Override
    public double direction(Vector3dc beta, Vector3dc d, Vector3d result) {
        double gamma = gamma(beta);
        double stretch = (gamma - 1) / beta.lengthSquared() * d.dot(beta) - gamma;
        new Vector3d(beta).mul(stretch).add(d).normalize(result);
        return gamma * (1 - d.dot(beta));
    }

    /** The angle from the velocity by the textbook's law of aberration. */
    public static double sceneAngle(double beta, double cameraAngle) {
        double cosine = Math.cos(cameraAngle);
        return Math.acos((cosine - beta) / (1 - beta * cosine));
    }

    /** The time of the fixed-point surface as the paper writes it. */
    public static double fixedPointTime(Vector3dc beta, Vector3dc place) {
        double gamma = 1 / Math.sqrt(1 - beta.lengthSquared());
        return (1 - gamma) * beta.dot(place) / (gamma * beta.lengthSquared());
    }
}
