package tompkins.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.joml.Vector3d;
import tompkins.fuzz.RandomStudio;
import tompkins.light.AmbientLight;
import tompkins.light.PointLight;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.MeshDetail;
import tompkins.ray.Ray;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cone;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Ellipsoid;
import tompkins.sceneobject.Lens;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.sceneobject.TriangleMesh;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.SkyBackground;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.surface.Shadow;
import tompkins.surface.Surface;

/**
 * A random scene in which two things touch, and another one that must look the same: with a gap between them that a ray
 * notices but nobody sees, or, for media, with single boundaries in place of two.
 *
 * @param touching the scene
 * @param other what it must look like
 * @param name tells it from others
 */
record TouchingPair(Studio touching, Studio other, String name) {

    /** In a scene of size 10. */
    private static final double GAP = 1e-9;

    /** What touches. */
    enum Kind {
        SHEETS,
        SHEET_ON_BODY,
        BACK_TO_BACK,
        SHEET_BETWEEN_BODIES,
        ONE_IN_THE_OTHER,
        MEDIA_BACK_TO_BACK,
        MEDIA_IN_EACH_OTHER
    }

    /** Where both are. */
    enum Home {
        SCENE,
        PLACED,
        MOVING,
        CAMERA_FRAME,
        TURNING
    }

    /** The pair with a number. */
    static TouchingPair of(long seed) {
        return new Maker(seed).pair();
    }

    private static final class Maker {

        private static final Class<?>[] SURFACES =
                Descriptions.members(Surface.class).toArray(Class<?>[]::new);

        private final SplittableRandom random;
        private final Kind kind;
        private final Home home;
        private final UnaryOperator<SceneObject> placed;
        private final double slant;

        Maker(long seed) {
            random = new SplittableRandom(seed);
            Kind[] kinds = Kind.values();
            kind = kinds[(int) (seed % kinds.length)];
            Home[] homes = Home.values();
            Home wanted = homes[(int) (seed / kinds.length % homes.length)];
            home = wanted == Home.TURNING && isOfMedia() ? Home.SCENE : wanted;
            slant = random.nextDouble(-0.3, 0.3);
            Vector3d axis = new Vector3d(number(), number(), number());
            double angle = random.nextBoolean() ? random.nextDouble(180) : 180 - random.nextDouble(60);
            double scale = home == Home.PLACED ? random.nextDouble(0.5, 2) : 1;
            Vector3d place = new Vector3d(number(), number(), 10);
            placed = object -> new Placed("", object, scale, axis, angle, place);
        }

        private boolean isOfMedia() {
            return kind == Kind.MEDIA_BACK_TO_BACK || kind == Kind.MEDIA_IN_EACH_OTHER;
        }

        private double number() {
            return random.nextDouble(-1, 1);
        }

        private Surface surface() {
            while (true) {
                Class<?> type = SURFACES[random.nextInt(SURFACES.length)];
                Surface surface = RandomStudio.surface(random.nextLong(), type);
                boolean isTame = surface.parts()
                        .noneMatch(part -> part instanceof Refractive medium
                                && (medium.indexRatio() > 3 || medium.indexRatio() < 0.3));
                if (isTame && !(surface instanceof Refractive) && (home != Home.TURNING || surface.canTurn())) {
                    return surface;
                }
            }
        }

        /** A surface, or at times a medium. */
        private Surface surfaceOfBody() {
            return home != Home.TURNING && random.nextInt(4) == 0 ? medium() : surface();
        }

        private Refractive medium() {
            return new Refractive(random.nextInt(4) == 0 ? 1.5 : random.nextDouble(0.4, 2.5));
        }

        private static boolean letsPass(Surface surface) {
            return surface.shadow() != Shadow.ALWAYS;
        }

        TouchingPair pair() {
            return switch (kind) {
                case SHEETS -> sheets();
                case SHEET_ON_BODY -> sheetOnBody();
                case BACK_TO_BACK -> backToBack(false);
                case SHEET_BETWEEN_BODIES -> backToBack(true);
                case ONE_IN_THE_OTHER -> oneInTheOther();
                case MEDIA_BACK_TO_BACK -> mediaBackToBack();
                case MEDIA_IN_EACH_OTHER -> mediaInEachOther();
            };
        }

        /** A flat piece at a height, whose front is up or down. */
        private Piece sheet(double size) {
            return sheet(size, random.nextInt(home == Home.TURNING ? 4 : 5));
        }

        private Piece sheet(double size, int shape) {
            double side = random.nextBoolean() ? 1 : -1;
            double x = number();
            double y = number();
            return (surface, height) -> {
                Vector3d u = new Vector3d(2 * size, 0.3 * size, 0);
                Vector3d v = new Vector3d(0.2, 2 * size * side, 0);
                Vector3d corner =
                        new Vector3d(x, y, height).sub(new Vector3d(u).add(v).div(2));
                return switch (shape) {
                    case 0 -> new Disc("disc", new Vector3d(x, y, height), new Vector3d(0, 0, side), size, surface);
                    case 1 -> new Parallelogram("piece", corner, u, v, surface);
                    case 2 ->
                        new Triangle(
                                "triangle",
                                corner,
                                new Vector3d(u).mul(1.5).add(corner),
                                new Vector3d(v).mul(1.5).add(corner),
                                surface);
                    case 3 -> new Parallelogram("other", new Vector3d(corner).add(v), v.negate(), u, surface);
                    default -> new Plane("plane", new Vector3d(x, y, height), new Vector3d(0, 0, side), surface);
                };
            };
        }

        /** Something flat, by its surface and its height. */
        private interface Piece {

            SceneObject at(Surface surface, double height);
        }

        private double frontOf(SceneObject sheet) {
            return PrimitiveCollector.primitivesOf(sheet).get(0).hit(Ray.from(0, 0, 5, 0, 0, -1, 0), 5).normalZ;
        }

        private TouchingPair sheets() {
            Surface first = surface();
            Surface second = surface();
            Piece large = sheet(6);
            Piece small = sheet(1.5, random.nextInt(4));
            boolean largeFirst = random.nextBoolean();
            Piece one = largeFirst ? large : small;
            Piece two = largeFirst ? small : large;
            // what lets light pass must be the smaller one, so that there are never two of it
            if (letsPass(first) != letsPass(second)) {
                one = letsPass(first) ? small : large;
                two = letsPass(first) ? large : small;
            }
            SceneObject listed = one.at(first, 0);
            SceneObject next = two.at(second, 0);
            List<SceneObject> apart;
            if (letsPass(first) && letsPass(second)) {
                apart = List.of(listed, two.at(second, -GAP * frontOf(listed)));
            } else if (letsPass(second)) {
                apart = List.of(listed, two.at(second, GAP), two.at(second, -GAP));
            } else {
                apart = List.of(one.at(first, GAP), one.at(first, -GAP), next);
            }
            return pair(List.of(listed, next), apart);
        }

        /** A body under the height. */
        private Piece below() {
            int shape = random.nextInt(5);
            double size = random.nextDouble(1, 2);
            return (surface, height) -> switch (shape) {
                case 0 -> new Box("box", new Vector3d(-2, -2, height - size), new Vector3d(2, 2, height), surface);
                case 1 ->
                    new Cylinder(
                            "cylinder",
                            new Vector3d(0, 0, height - size),
                            new Vector3d(0, 0, height),
                            2,
                            true,
                            surface);
                case 2 ->
                    new Cone("cone", new Vector3d(0, 0, height - size), new Vector3d(0, 0, height), 2, true, surface);
                case 3 -> new Lens("lens", new Vector3d(0, 0, height), new Vector3d(0, 0, 1), 2, 0, 0, 0.3, surface);
                default -> new TriangleMesh("mesh", pyramid(height, size), surface, false);
            };
        }

        /** A body above the height. */
        private Piece above() {
            Piece same = below();
            return (surface, height) ->
                    new Placed("above", same.at(surface, 0), 1, new Vector3d(1, 0, 0), 180, new Vector3d(0, 0, height));
        }

        private static MeshData pyramid(double height, double size) {
            double[] corners = {-2, -2, height, 2, -2, height, 2, 2, height, -2, 2, height, 0, 0, height - size};
            int[] faces = {0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4};
            return new MeshData("", corners, faces, MeshDetail.NONE, new byte[0]);
        }

        private TouchingPair sheetOnBody() {
            Surface onSheet = surface();
            Surface ofBody = surfaceOfBody();
            Piece sheet = sheet(1.2);
            Piece body = below();
            return pair(
                    mixed(sheet.at(onSheet, 0), body.at(ofBody, 0)),
                    List.of(sheet.at(onSheet, GAP), body.at(ofBody, 0)));
        }

        private TouchingPair backToBack(boolean withSheet) {
            Surface lower = surfaceOfBody();
            Surface upper = !withSheet && lower instanceof Refractive ? surface() : surfaceOfBody();
            Piece below = below();
            Piece above = above();
            if (!withSheet) {
                return pair(
                        mixed(below.at(lower, 0), above.at(upper, 0)),
                        List.of(below.at(lower, 0), above.at(upper, GAP)));
            }
            Surface onSheet = surface();
            // everywhere, so that no media touch
            Piece sheet = sheet(8);
            List<SceneObject> touching = new ArrayList<>(mixed(below.at(lower, 0), above.at(upper, 0)));
            touching.add(random.nextInt(3), sheet.at(onSheet, 0));
            return pair(touching, List.of(below.at(lower, -GAP), sheet.at(onSheet, 0), above.at(upper, GAP)));
        }

        private List<SceneObject> mixed(SceneObject one, SceneObject other) {
            return random.nextBoolean() ? List.of(one, other) : List.of(other, one);
        }

        /** Any closed shape around the origin. */
        private Shape closed() {
            int shape = random.nextInt(7);
            return surface -> switch (shape) {
                case 0 -> new Sphere("sphere", new Vector3d(), 1.7, surface);
                case 1 -> new Ellipsoid("ellipsoid", new Vector3d(), new Vector3d(1.2, 2, 1.5), surface);
                case 2 -> new Box("box", new Vector3d(-1, -2, -1.5), new Vector3d(1, 2, 1.5), surface);
                case 3 -> new Cylinder("cylinder", new Vector3d(0, -1, 0), new Vector3d(0.3, 1, 0), 1.5, true, surface);
                case 4 -> new Cone("cone", new Vector3d(0, 1, 0), new Vector3d(0, -1, 0.3), 1.5, true, surface);
                case 5 -> new Lens("lens", new Vector3d(), new Vector3d(0, 0.3, 1), 1.5, 0.4, 0.3, 0.2, surface);
                default ->
                    new Placed(
                            "octahedron",
                            new TriangleMesh("mesh", MeshData.OCTAHEDRON, surface, false),
                            2,
                            new Vector3d(1, 2, 3),
                            30,
                            new Vector3d());
            };
        }

        /** A shape, by its surface. */
        private interface Shape {

            SceneObject of(Surface surface);
        }

        private TouchingPair oneInTheOther() {
            Surface first = surfaceOfBody();
            Surface second = first instanceof Refractive ? surface() : surfaceOfBody();
            Shape shape = closed();
            boolean firstInside = letsPass(second) && !letsPass(first);
            SceneObject one = shape.of(first);
            SceneObject two = shape.of(second);
            SceneObject inner =
                    new Placed("inner", firstInside ? one : two, 1 - GAP, new Vector3d(0, 0, 1), 0, new Vector3d());
            return pair(List.of(one, two), List.of(firstInside ? two : one, inner));
        }

        private TouchingPair mediaInEachOther() {
            Refractive first = medium();
            Refractive second = random.nextInt(4) == 0 ? new Refractive(1 / first.indexRatio()) : medium();
            Shape shape = closed();
            double product = first.indexRatio() * second.indexRatio();
            return pair(
                    List.of(shape.of(first), shape.of(second)),
                    Math.abs(product - 1) < 1e-9 ? List.of() : List.of(shape.of(new Refractive(product))));
        }

        private TouchingPair mediaBackToBack() {
            double lower = medium().indexRatio();
            double upper = random.nextInt(4) == 0 ? lower : medium().indexRatio();
            Vector3d from = new Vector3d(-2, -1.5, -1);
            Vector3d to = new Vector3d(2, 1.5, 1.5);
            List<SceneObject> single = new ArrayList<>();
            addSides(from, new Vector3d(to.x, to.y, 0), new Refractive(lower), single);
            addSides(new Vector3d(from.x, from.y, 0), to, new Refractive(upper), single);
            single.add(face(from.x, to.y, from.z, to.x - from.x, from.y - to.y, new Refractive(lower)));
            single.add(face(from.x, from.y, to.z, to.x - from.x, to.y - from.y, new Refractive(upper)));
            if (lower != upper) {
                single.add(face(from.x, from.y, 0, to.x - from.x, to.y - from.y, new Refractive(lower / upper)));
            }
            return pair(
                    mixed(
                            new Box("lower", from, new Vector3d(to.x, to.y, 0), new Refractive(lower)),
                            new Box("upper", new Vector3d(from.x, from.y, 0), to, new Refractive(upper))),
                    single);
        }

        /** A face across z; it faces up if both spans are positive. */
        private static SceneObject face(double x, double y, double z, double width, double height, Surface surface) {
            return new Parallelogram(
                    "face", new Vector3d(x, y, z), new Vector3d(width, 0, 0), new Vector3d(0, height, 0), surface);
        }

        /** The four faces of a box along z. */
        private static void addSides(Vector3d from, Vector3d to, Surface surface, List<SceneObject> all) {
            Vector3d x = new Vector3d(to.x - from.x, 0, 0);
            Vector3d y = new Vector3d(0, to.y - from.y, 0);
            Vector3d z = new Vector3d(0, 0, to.z - from.z);
            all.add(new Parallelogram("left", from, z, y, surface));
            all.add(new Parallelogram("low", from, x, z, surface));
            all.add(new Parallelogram("right", new Vector3d(from).add(x), y, z, surface));
            all.add(new Parallelogram("high", new Vector3d(from).add(y), z, x, surface));
        }

        private TouchingPair pair(List<SceneObject> touching, List<SceneObject> apart) {
            long rest = random.nextLong();
            return new TouchingPair(studio(touching, rest), studio(apart, rest), kind + " in " + home + " " + touching);
        }

        private Studio studio(List<SceneObject> objects, long rest) {
            SplittableRandom same = new SplittableRandom(rest);
            List<SceneObject> scene = new ArrayList<>(List.of(
                    new Plane("mirror", new Vector3d(0, 0, 16), new Vector3d(0.1, 0.05, -1), new Mirror(0.9)),
                    new Plane(
                            "floor",
                            new Vector3d(0, -6, 0),
                            new Vector3d(0, 1, 0),
                            new ColouredSurface(Colour.grey(0.7), Colour.BLACK)),
                    new Sphere(
                            "ball",
                            new Vector3d(3, 3, 4),
                            1,
                            new ColouredSurface(new Colour(0.8, 0.3, 0.1), Colour.BLACK))));
            List<SceneObject> all = objects.stream().map(placed).toList();
            Velocity camera = same.nextInt(3) == 0 ? Velocity.of(0.2, 0.1, same.nextDouble(-0.8, 0.8)) : Velocity.REST;
            List<SceneObject> before = List.of();
            switch (home) {
                case SCENE, PLACED -> scene.addAll(same.nextInt(4), all);
                case MOVING ->
                    scene.add(new Moving(
                            "moving",
                            Velocity.of(same.nextDouble(-0.5, 0.5), same.nextDouble(-0.5, 0.5), 0.4),
                            new Vector3d(0, 0, 4),
                            0.3,
                            all));
                case CAMERA_FRAME -> before = all;
                case TURNING ->
                    scene.add(new Rotating(
                            "turning",
                            new Vector3d(0, 0, 10),
                            new Vector3d(0.2, 1, slant),
                            same.nextDouble(-0.02, 0.02),
                            same.nextDouble(360),
                            all));
            }
            Studio lit = Lighting.of(
                    Studios.dark().withScene(scene).withCameraFrame(before),
                    List.of(
                            new AmbientLight(Colour.grey(0.3)),
                            new PointLight(new Vector3d(4, 8, -2), Colour.grey(0.5), Colour.grey(0.2), 20),
                            new PointLight(new Vector3d(-4, 3, 18), Colour.grey(0.5), Colour.grey(0.2), 20)));
            return Descriptions.with(lit, "background", SkyBackground.DEFAULT)
                    .withVelocity(camera)
                    .withSettings(Descriptions.with(Studio.DEFAULT.settings().withSize(64, 64), "maximumDepth", 12));
        }
    }
}
