package tompkins.study;

import java.util.function.Function;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector4d;
import tompkins.spacetime.LorentzTransformation;
import tompkins.spacetime.Velocity;

/** A form of the Lorentz transformation of directions, from the camera frame to the scene frame. */
enum DirectionForm {

    /** The program's own. */
    HALF_ANGLE("half angles, double", velocity -> new LorentzTransformation(velocity)::direction),

    /** {@code d + u ((u.d)/(gamma + 1) - |d|)} with the proper velocity u. */
    PROPER_VELOCITY("proper velocity, double", velocity -> {
        Vector3dc u = velocity.proper();
        double shrink = 1 / (velocity.gamma() + 1);
        return (d, result) -> new Vector3d(u).mul(u.dot(d) * shrink - 1).add(d).normalize(result);
    }),

    /** A matrix that acts on the 4-vector (d, -1). */
    MATRIX("4 x 4 matrix, double", velocity -> {
        Vector3dc u = velocity.proper();
        double k = 1 / (velocity.gamma() + 1);
        Matrix4d boost = new Matrix4d(
                new Vector4d(1 + k * u.x() * u.x(), k * u.x() * u.y(), k * u.x() * u.z(), u.x()),
                new Vector4d(k * u.y() * u.x(), 1 + k * u.y() * u.y(), k * u.y() * u.z(), u.y()),
                new Vector4d(k * u.z() * u.x(), k * u.z() * u.y(), 1 + k * u.z() * u.z(), u.z()),
                new Vector4d(u.x(), u.y(), u.z(), velocity.gamma()));
        Vector4d event = new Vector4d();
        return (d, result) -> {
            boost.transform(event.set(d.x(), d.y(), d.z(), -1));
            result.set(event.x, event.y, event.z).normalize();
        };
    }),

    /** As textbooks write it, from beta, with gamma from 1 - beta^2. */
    NAIVE("textbook (beta), double", velocity -> {
        Vector3d beta = new Vector3d(velocity.proper()).div(velocity.gamma());
        double square = beta.lengthSquared();
        double gamma = 1 / Math.sqrt(1 - square);
        return (d, result) -> new Vector3d(beta)
                .mul((gamma - 1) / square * beta.dot(d) - gamma)
                .add(d)
                .normalize(result);
    }),

    /** As {@link #PROPER_VELOCITY}, in single precision. */
    SINGLE("proper velocity, float", velocity -> {
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
