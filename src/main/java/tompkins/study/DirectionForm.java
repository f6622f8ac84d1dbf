package tompkins.study;

import java.util.function.Function;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.spacetime.LorentzTransformation;
import tompkins.spacetime.Velocity;

/** A form of the Lorentz transformation of directions, from the camera frame to the scene frame. */
enum DirectionForm {

    /** The program's own. */
    HALF_ANGLE("half angles (double)", velocity -> new LorentzTransformation(velocity)::direction),

    /** {@code d + u ((u.d)/(gamma + 1) - |d|)} with the proper velocity u. */
    PROPER_VELOCITY("proper velocity (double)", velocity -> {
        Vector3dc u = velocity.proper();
        double shrink = 1 / (velocity.gamma() + 1);
        return (d, result) -> new Vector3d(u).mul(u.dot(d) * shrink - 1).add(d).normalize(result);
    }),

    /** As textbooks write it, from beta, with gamma from 1 - beta^2. */
    NAIVE("textbook form (double)", velocity -> {
        Vector3d beta = new Vector3d(velocity.proper()).div(velocity.gamma());
        double square = beta.lengthSquared();
        double gamma = 1 / Math.sqrt(1 - square);
        return (d, result) -> new Vector3d(beta)
                .mul((gamma - 1) / square * beta.dot(d) - gamma)
                .add(d)
                .normalize(result);
    }),

    /** As {@link #PROPER_VELOCITY}, in single precision. */
    SINGLE("proper velocity (float)", velocity -> {
        float ux = (float) velocity.proper().x();
        float uy = (float) velocity.proper().y();
        float uz = (float) velocity.proper().z();
        float shrink = 1 / ((float) velocity.gamma() + 1);
        return (d, result) -> {
            float x = (float) d.x();
            float y = (float) d.y();
            float z = (float) d.z();
            float factor = (ux * x + uy * y + uz * z) * shrink - 1;
            x += ux * factor;
            y += uy * factor;
            z += uz * factor;
            float length = (float) Math.sqrt(x * x + y * y + z * z);
            result.set(x / length, y / length, z / length);
        };
    });

    /** Turns a unit direction. */
    @FunctionalInterface
    interface Direction {

        /** Puts the unit direction in the scene frame into {@code result}. */
        void turn(Vector3dc d, Vector3d result);
    }

    private final String title;
    private final Function<Velocity, Direction> form;

    DirectionForm(String title, Function<Velocity, Direction> form) {
        this.title = title;
        this.form = form;
    }

    String title() {
        return title;
    }

    Direction of(Velocity velocity) {
        return form.apply(velocity);
    }
}
