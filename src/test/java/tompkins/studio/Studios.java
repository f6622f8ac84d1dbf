package tompkins.studio;

import java.util.List;
import org.joml.Vector3d;
import tompkins.camera.FieldOfView;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;

/** Studios for tests. */
public final class Studios {

    private Studios() {}

    /** An empty scene without lamps, before a black sky. */
    public static Studio dark() {
        return Descriptions.with(
                Lighting.of(Studio.DEFAULT, List.of()), "background", new UniformBackground(Colour.BLACK));
    }

    /** A sphere straight ahead, 64 x 48 pixels, at rest. */
    public static Studio sphere() {
        return Studio.DEFAULT
                .withScene(List.of(Sphere.DEFAULT))
                .withSettings(Studio.DEFAULT.settings().withSize(64, 48));
    }

    /** The lattice of the paper, 640 x 480 pixels, in fast motion. */
    public static Studio lattice() {
        return Studio.DEFAULT.withScene(List.of(CylinderLattice.DEFAULT)).withVelocity(Velocity.of(0.1, 0, 0.99));
    }

    /** A picture that would take minutes. */
    public static Studio slow() {
        Studio lattice = lattice();
        return lattice.withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "apertureRadius", 0.1))
                .withSettings(lattice.settings().withSize(1600, 1200).withSamples(4096));
    }

    /** Stars behind a ball in focus, near the lens: for a large picture the places of their spots take seconds. */
    public static Studio blurredStars() {
        Vector3d ahead = new Vector3d(0, 0, 1);
        Sphere focus = new Sphere("focus", ahead, 0.6, Sphere.DEFAULT.surface());
        return Descriptions.with(Studio.DEFAULT, "background", StarSky.DEFAULT)
                .withCamera(Descriptions.with(
                        Descriptions.with(FieldOfView.with(ThinLensCamera.DEFAULT, 90), "apertureRadius", 0.5),
                        "focus",
                        focus));
    }
}
