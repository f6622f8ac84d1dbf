package tompkins.trace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector3i;
import org.junit.jupiter.api.Named;
import tompkins.camera.Camera;
import tompkins.camera.Cameras;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.Stereo;
import tompkins.camera.StereoLayout;
import tompkins.camera.ThinLensCamera;
import tompkins.light.AmbientLight;
import tompkins.light.ColourLaw;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cone;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Ellipsoid;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Lens;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Silhouette;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.sceneobject.TriangleMesh;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.LensEvent;
import tompkins.studio.Lighting;
import tompkins.studio.PaperStudios;
import tompkins.studio.SkyBackground;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.surface.Blinking;
import tompkins.surface.Clear;
import tompkins.surface.Clock;
import tompkins.surface.ColourFilter;
import tompkins.surface.ColouredSurface;
import tompkins.surface.CutOut;
import tompkins.surface.LorentzWindow;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Mixture;
import tompkins.surface.PictureSurface;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;
import tompkins.surface.Tiling;
import tompkins.surface.TwoSided;
import tompkins.surface.WindowAxes;

/** Studios that are hard for a search, and that no bundled scene is: crowds, dust, and hits that are equally near. */
public final class VariedStudios {

    private static final Surface GREY = new ColouredSurface(Colour.grey(0.8), Colour.WHITE);

    private VariedStudios() {}

    /** All of them, with names. */
    public static Stream<Named<Studio>> all() {
        return Stream.of(crowds(), dusts(), motions()).flatMap(studios -> studios);
    }

    private static Stream<Named<Studio>> crowds() {
        Studio studio = moving(crowd());
        PointLight inside = lamp(0.2, 0.1, 6, 0.7);
        PointLight beside = lamp(-6, 1, 5, 0.5);
        PanoramicCamera allAround = PanoramicCamera.DEFAULT;
        ThinLensCamera veryWide = Cameras.lens(
                new Vector3d(0.1, 0.2, 4),
                new Vector3d(0.2, -0.1, 1),
                new Vector3d(0.1, 1, 0),
                150,
                0,
                0.3,
                new Sphere("focus", new Vector3d(0, 0, 4), 3, GREY),
                0.5,
                new FocusSurfaceShutter(-3));
        Camera behind = Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d(0, 0, 14));
        Camera back = Descriptions.with(
                Descriptions.with(behind, "viewDirection", new Vector3d(0, 0, -1)), "horizontalAngleDegrees", 30.0);
        Studio late = studio.withCamera(PaperStudios.camera(0, new AperturePlaneShutter(1e7)));
        Vector3dc farAway = LensEvent.inScene(late).position();
        Placed nearTheCamera = new Placed("placed", new Group("crowd", crowd()), 1, new Vector3d(0, 1, 0), 0, farAway);
        Surface tilted = new LorentzWindow(Velocity.of(0.1, 0.05, 0.3), WindowAxes.SURFACE, 0.9);
        return Stream.of(
                Named.of("crowd through a wide aperture", samples(wide(studio), 3)),
                Named.of(
                        "three lamps",
                        Lighting.of(studio, List.of(PointLight.DEFAULT, AmbientLight.DEFAULT, inside, beside))),
                Named.of(
                        "two lamps at one place", Lighting.of(studio, List.of(PointLight.DEFAULT, PointLight.DEFAULT))),
                Named.of(
                        "three lamps, a few objects",
                        Lighting.of(moving(few()), List.of(PointLight.DEFAULT, inside, beside))),
                Named.of(
                        "crowd before the lens",
                        Lighting.of(
                                moving(with(crowd(), window(2, tilted))).withCameraFrame(crowd()),
                                List.of(lamp(0, 4, 0, 1), PointLight.DEFAULT))),
                Named.of(
                        "anaglyph through a very wide aperture inside the scene",
                        samples(stereo(studio.withCamera(veryWide), StereoLayout.ANAGLYPH), 2)),
                Named.of("camera that looks back", studio.withCamera(back)),
                Named.of(
                        "panoramic camera, rolling slit",
                        samples(exposed(studio.withCamera(allAround), 0.5, 3, SweepDirection.RIGHT), 2)),
                Named.of("nearly the speed of light", studio.withVelocity(Velocity.of(0, 0, 0.9999999))),
                Named.of("far from the origin", late.withScene(List.of(nearTheCamera))));
    }

    private static Stream<Named<Studio>> dusts() {
        Studio studio = moving(dust());
        return Stream.of(
                Named.of("dust, two lamps", Lighting.of(studio, List.of(PointLight.DEFAULT, lamp(0.2, 0.1, 9, 0.7)))),
                Named.of("dust through a wide aperture", samples(wide(studio), 2)),
                Named.of("dust behind a window", studio.withCameraFrame(List.of(window(3, Clear.DEFAULT)))),
                Named.of(
                        "moving dust",
                        moving(List.of(flying(Velocity.of(0.6, 0.1, 0), dust())))
                                .withCameraFrame(List.of(window(3, Clear.DEFAULT)))));
    }

    private static Studio stereo(Studio studio, StereoLayout layout) {
        return studio.withCamera(studio.camera().withStereo(Stereo.DEFAULT.withLayout(layout)));
    }

    private static Studio exposed(Studio studio, double time, double sweep, SweepDirection direction) {
        Camera slow = Descriptions.with(studio.camera(), "exposureTime", time);
        return studio.withCamera(Descriptions.with(slow, "rollingShutter", new RollingShutter(direction, sweep)));
    }

    private static Studio moving(List<SceneObject> scene) {
        Studio studio = Descriptions.with(Studio.DEFAULT.withScene(scene), "background", SkyBackground.DEFAULT)
                .withCamera(PaperStudios.camera(0, AperturePlaneShutter.DEFAULT))
                .withVelocity(Velocity.of(0.1, -0.05, 0.6));
        return studio.withSettings(studio.settings().withSize(80, 60));
    }

    /** Crowds that fly through each other, with clocks, lamps and all kinds of surfaces. */
    private static Stream<Named<Studio>> motions() {
        Clock clock = new Clock(2, GREY, Mirror.DEFAULT, true);
        Blinking blinking = new Blinking(1, GREY, Clear.DEFAULT);
        List<SceneObject> clocks = List.of(
                new Disc("clock", new Vector3d(-0.6, 0.2, 4), new Vector3d(0, 0, -1), 0.5, clock),
                new Disc("blinking", new Vector3d(0.6, 0.2, 4), new Vector3d(0, 0, -1), 0.5, blinking));
        Velocity right = Velocity.of(0.6, 0.1, 0);
        Moving nested = flying(Velocity.of(0, 0.3, 0), with(clocks, flying(Velocity.of(0, 0, -0.5), few())));
        List<SceneObject> crowds = List.of(
                flying(right, crowd()), flying(Velocity.of(-0.5, 0, 0.2), few()), flying(right, clocks), nested);
        Studio studio = moving(with(few(), crowds.toArray(SceneObject[]::new)));
        MovingLights lamps =
                new MovingLights(right, new Vector3d(0, 3, 6), List.of(lamp(0, 0, 0, 0.5), lamp(1, 1, 1, 0.4)));
        Studio lit = Lighting.of(studio, List.of(AmbientLight.DEFAULT, PointLight.DEFAULT, lamps));
        return Stream.of(
                Named.of("moving crowds through a wide aperture", samples(wide(studio), 2)),
                Named.of("wheels, shifted colours", wheels(lit).withColours(ColourLaw.DOPPLER)),
                Named.of("wheels, Galilean world", wheels(lit).withTransformation(TransformationLaw.GALILEAN)),
                Named.of("wheels, measured", wheels(lit).withView(View.MEASURED)),
                Named.of("moving lamps", lit),
                Named.of("measured", shallow(lit.withView(View.MEASURED))));
    }

    /** Wheels at rest and in motion, with spokes, a clock, mirrors and parts that light passes. */
    private static Studio wheels(Studio studio) {
        List<SceneObject> parts = new ArrayList<>();
        for (int i = 0; i < 30; i++) {
            double angle = Math.PI * i / 15;
            Vector3d end = new Vector3d(Math.cos(angle), Math.sin(angle), 0);
            parts.add(new Cylinder("spoke", new Vector3d(end).mul(0.1), end, 0.02, i % 3 > 0, GREY));
        }
        Vector3d forwards = new Vector3d(0, 0, 1);
        parts.add(new Cylinder("tyre", new Vector3d(0, 0, -0.1), new Vector3d(0, 0, 0.1), 1, false, Tiling.DEFAULT));
        parts.add(new Disc(
                "clock", new Vector3d(0.6, 0.2, -0.2), forwards, 0.2, new Clock(2, GREY, Clear.DEFAULT, true)));
        parts.add(new Sphere("mirror", new Vector3d(-0.6, 0.2, 0), 0.2, new Mirror(0.9)));
        Rotating wheel = new Rotating("wheel", new Vector3d(), forwards, -0.9, 20, parts);
        SceneObject left = new Placed("left", wheel, 0.7, new Vector3d(0, 1, 0), 30, new Vector3d(-0.8, 0, 4));
        SceneObject right = new Placed("right", wheel, 1, new Vector3d(0, 1, 0), 0, new Vector3d(0.8, 0.2, 5));
        return studio.withScene(with(List.of(left, few().get(0)), flying(Velocity.of(0.5, 0, 0), List.of(right))));
    }

    private static Moving flying(Velocity velocity, List<SceneObject> objects) {
        return new Moving("flying", velocity, new Vector3d(0.1, -0.2, 0.3), 0.5, objects);
    }

    private static Studio wide(Studio studio) {
        return studio.withCamera(PaperStudios.camera(0.2, new DetectorPlaneShutter(1.12, 1)));
    }

    /** Balls of glass that have flown into each other keep most light; all of it would take minutes. */
    private static Studio shallow(Studio studio) {
        return studio.withSettings(Descriptions.with(studio.settings(), "maximumDepth", 10));
    }

    private static Studio samples(Studio studio, int samples) {
        return studio.withSettings(studio.settings().withSamples(samples));
    }

    /** One object of each kind and surface, fewer than a tree needs, with hits that are exactly equally near. */
    private static List<SceneObject> few() {
        PixelPicture chequers = new PixelPicture(
                "chequers", 2, 2, new float[] {0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1}, new byte[0]);
        Vector3d right = new Vector3d(1, 0, 0);
        Vector3d up = new Vector3d(0, 1, 0);
        return List.of(
                PaperStudios.fig1a().scene().get(0),
                new Silhouette("cut-out", new Vector3d(-1.4, 0, 5), right, up, chequers, GREY),
                new Parallelogram(
                        "screen",
                        new Vector3d(0.4, 0, 5),
                        right,
                        up,
                        new CutOut(chequers, new Mirror(0.9), Clear.DEFAULT)),
                new Sphere("glass", new Vector3d(0, 0, 6), 0.5, new Refractive(1.5)),
                new Ellipsoid("ellipsoid", new Vector3d(0.3, -0.7, 5.5), new Vector3d(0.3, 0.15, 0.2), GREY),
                new Lens(
                        "lens",
                        new Vector3d(0.9, 0.2, 6),
                        new Vector3d(1, 0, -3),
                        0.3,
                        0.05,
                        2,
                        -1,
                        Refractive.DEFAULT),
                new Sphere("mirror", new Vector3d(-1, -0.5, 7), 0.4, new Mirror(0.9)),
                new Sphere("filter", new Vector3d(1, -0.6, 7), 0.3, new ColourFilter(new Colour(0.9, 0.5, 0.2))),
                new Box("box", new Vector3d(0.8, 0.6, 8), new Vector3d(1.4, 1.2, 9), GREY),
                new Cylinder(
                        "tube",
                        new Vector3d(-0.6, 0.1, 6),
                        new Vector3d(-0.9, 0.4, 7),
                        0.15,
                        false,
                        new TwoSided(GREY, new Mixture(GREY, Clear.DEFAULT, 0.4))),
                new Placed(
                        "placed",
                        new Box("box", new Vector3d(), right.add(0, 1, 1, new Vector3d()), Clear.DEFAULT),
                        0.5,
                        new Vector3d(1, 1, 0),
                        30,
                        new Vector3d(-0.5, 0.8, 7)),
                new Placed(
                        "placed mesh",
                        new TriangleMesh("mesh", MeshData.OCTAHEDRON, new PictureSurface(chequers, false, true), true),
                        0.3,
                        new Vector3d(1, 1, 0),
                        20,
                        new Vector3d(0.6, -0.2, 7.5)),
                new Cone("cone", new Vector3d(-1.2, 1.5, 8), new Vector3d(-1.2, 0.5, 8), 0.4, true, GREY),
                new Cylinder("rod", new Vector3d(-1, -1, 9), new Vector3d(1, 1, 9), 0.1, true, GREY),
                new Cylinder(
                        "crossing rod",
                        new Vector3d(-1, 1, 9),
                        new Vector3d(1, -1, 9),
                        0.1,
                        true,
                        new ColouredSurface(new Colour(1, 0, 0), Colour.BLACK)),
                new Disc("lamp", new Vector3d(0, 1.3, 8), new Vector3d(0, 0, -1), 0.2, LuminousSurface.DEFAULT),
                new Triangle("triangle", new Vector3d(-1, -1, 8), new Vector3d(0, -1, 8), new Vector3d(0, 0, 8), GREY),
                new Parallelogram(
                        "same place",
                        new Vector3d(-1, -1, 8),
                        right,
                        up,
                        new ColouredSurface(Colour.WHITE, Colour.BLACK)));
    }

    /** The same among so many spheres and rods that a tree is built. */
    private static List<SceneObject> crowd() {
        List<SceneObject> objects = new ArrayList<>(few());
        Random random = new Random(20160921);
        for (int i = 0; i < 150; i++) {
            Vector3dc centre =
                    new Vector3d(random.nextDouble(-3, 3), random.nextDouble(-1, 3), random.nextDouble(2, 14));
            Colour colour = new Colour(random.nextDouble(), random.nextDouble(), random.nextDouble());
            objects.add(new Sphere(
                    "sphere " + i, centre, random.nextDouble(0.02, 0.15), new ColouredSurface(colour, Colour.WHITE)));
        }
        CylinderLattice usual = CylinderLattice.DEFAULT;
        objects.add(new CylinderLattice(
                "lattice",
                usual.from(),
                usual.to(),
                new Vector3i(4),
                0.02,
                usual.surfaceAlongX(),
                usual.surfaceAlongY(),
                usual.surfaceAlongZ()));
        return objects;
    }

    /** Very many small objects: a block of rays meets far more of them than it could test one by one. */
    private static List<SceneObject> dust() {
        List<SceneObject> objects = new ArrayList<>();
        Random random = new Random(3000);
        for (int i = 0; i < 2500; i++) {
            Vector3d place =
                    new Vector3d(random.nextDouble(-2, 2), random.nextDouble(-1.5, 1.5), random.nextDouble(6, 12));
            Surface surface = i % 7 == 0 ? Mirror.DEFAULT : GREY;
            Vector3d end = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), 0).add(place);
            objects.add(
                    i % 3 == 0
                            ? new Cylinder("rod", place, end, 0.004, true, surface)
                            : new Sphere("grain", place, 0.05, surface));
        }
        return objects;
    }

    private static List<SceneObject> with(List<SceneObject> objects, SceneObject... more) {
        return Stream.concat(objects.stream(), Arrays.stream(more)).toList();
    }

    private static SceneObject window(double z, Surface surface) {
        return new Parallelogram(
                "window", new Vector3d(-0.5, -0.4, z), new Vector3d(0.8, 0, 0.1), new Vector3d(0, 0.7, 0), surface);
    }

    private static PointLight lamp(double x, double y, double z, double brightness) {
        return new PointLight(new Vector3d(x, y, z), Colour.grey(brightness), Colour.WHITE, 20);
    }
}
