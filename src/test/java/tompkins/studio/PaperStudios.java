package tompkins.studio;

import java.util.List;
import org.joml.Vector2i;
import org.joml.Vector3d;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.Velocity;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Tiling;

/** Three figures of the paper (Courtial et al. 2016), made without files. */
public final class PaperStudios {

    /** The velocity of the camera in the paper, 99.5 % of that of light. */
    public static final Velocity VELOCITY = Velocity.of(0.2, -0.1, 0.97);

    private static final SceneObject FLOOR = new Plane(
            "floor",
            new Vector3d(0, -1, 0),
            new Vector3d(0, 1, 0),
            new Tiling(
                    new ColouredSurface(Colour.grey(0.5), Colour.WHITE),
                    new ColouredSurface(Colour.WHITE, Colour.WHITE),
                    1,
                    1,
                    false));

    private static final SceneObject WHITE_SPHERES = new ImagePointGrid(
            "white spheres",
            new Sphere("white sphere", new Vector3d(), 0.025, new ColouredSurface(Colour.grey(2), Colour.WHITE)),
            new Vector3d(-1, -1, 10),
            new Vector3d(2, 0, 0),
            new Vector3d(0, 2, 0),
            new Vector2i(9, 9));

    private PaperStudios() {}

    /** Fig. 1(a): the scene with the camera at rest. */
    public static Studio fig1a() {
        return Studio.DEFAULT
                .withScene(List.of(FLOOR, CylinderLattice.DEFAULT))
                .withCamera(camera(0, AperturePlaneShutter.DEFAULT));
    }

    /** Fig. 1(b): the same with the camera in motion. */
    public static Studio fig1b() {
        return fig1a().withVelocity(VELOCITY);
    }

    /** Fig. 3(a): through a wide aperture, with the shutter in the detector plane; one sample per pixel. */
    public static Studio fig3a() {
        return fig1b().withScene(List.of(WHITE_SPHERES, FLOOR, CylinderLattice.DEFAULT))
                .withCamera(camera(0.05, new DetectorPlaneShutter(1.12, 1)));
    }

    /** The camera of the paper. */
    public static Camera camera(double apertureRadius, Shutter shutter) {
        Camera wide = Descriptions.with(
                ThinLensCamera.DEFAULT.withShutter(shutter), "horizontalAngleDegrees", 20.03066570511592);
        Camera high = Descriptions.with(wide, "verticalAngleDegrees", 15.097852663761984);
        return Descriptions.with(high, "apertureRadius", apertureRadius);
    }
}
