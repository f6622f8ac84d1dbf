package tompkins.spacetime;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A way to work out a change of frame, from the frame that moves with beta; with -beta it is the way back. */
public interface FrameMethod {

    /** The Lorentz factor. */
    double gamma(Vector3dc beta);

    /** The Lorentz factor minus 1. */
    double gammaMinusOne(Vector3dc beta);

    /** The event in the other frame. */
    Event event(Vector3dc beta, Event event);

    /** The unit direction of a traced ray in the other frame, for a unit direction d; returns |d'|/|d|. */
    double direction(Vector3dc beta, Vector3dc d, Vector3d result);

    /** The way of the program. */
    FrameMethod PROGRAM = new FrameMethod() {

        @Override
        public double gamma(Vector3dc beta) {
            return Velocity.of(beta).gamma();
        }

        @Override
        public double gammaMinusOne(Vector3dc beta) {
            return Velocity.of(beta).gammaMinusOne();
        }

        @Override
        public Event event(Vector3dc beta, Event event) {
            return new LorentzTransformation(Velocity.of(beta)).transform(event);
        }

        @Override
        public double direction(Vector3dc beta, Vector3dc d, Vector3d result) {
            return new LorentzTransformation(Velocity.of(beta)).direction(d, result);
        }
    };
}
