package tompkins.sceneobject;

import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.MeshData;
import tompkins.surface.Surface;

/**
 * A sample of every shape, which all contract tests ask for: a new shape is named here, once. Each grows with its size
 * and moves with its middle, so that samples of other sizes are the same shapes, scaled.
 */
public final class SampleShapes {

    private SampleShapes() {}

    /** Shapes with an inside, at most twice their size from their middle. */
    public static Stream<SceneObject> closed(Vector3dc middle, double size, Surface surface) {
        return Stream.of(
                new Sphere("sphere", new Vector3d(middle), size, surface),
                new Placed(
                        "ellipsoid",
                        new Ellipsoid("ellipsoid", new Vector3d(), new Vector3d(1, 0.5, 0.7), surface),
                        size,
                        new Vector3d(3, -1, 2),
                        50,
                        new Vector3d(middle)),
                new Box("box", at(middle, size, -0.8, -1, -1), at(middle, size, 0.7, 0.7, 1), surface),
                new Cylinder(
                        "cylinder",
                        at(middle, size, -0.8, -1, -0.9),
                        at(middle, size, 0.5, 1, 0.1),
                        0.7 * size,
                        true,
                        surface),
                new Cone(
                        "cone",
                        at(middle, size, 0.5, 1, 0.1),
                        at(middle, size, -0.8, -1, -0.9),
                        0.8 * size,
                        true,
                        surface),
                new Placed(
                        "lens",
                        new Lens("lens", new Vector3d(), new Vector3d(1, -2, 2), 0.9, 0.6, 0.8, -0.5, surface),
                        size,
                        new Vector3d(1, 0, 2),
                        70,
                        new Vector3d(middle)),
                new Placed(
                        "mesh",
                        new TriangleMesh("octahedron", MeshData.OCTAHEDRON, surface, true),
                        size,
                        new Vector3d(1, 2, 3),
                        40,
                        new Vector3d(middle)));
    }

    /** Shapes without an inside, at most twice their size from their middle. */
    public static Stream<SceneObject> open(Vector3dc middle, double size, Surface surface) {
        return Stream.of(
                new Disc("disc", new Vector3d(middle), new Vector3d(1, 1, -3), size, surface),
                new Parallelogram(
                        "parallelogram",
                        at(middle, size, -0.8, -1, -0.5),
                        at(new Vector3d(), size, 1.2, 0.4, 0.9),
                        at(new Vector3d(), size, 0.3, 1.5, -0.2),
                        surface),
                new Triangle(
                        "triangle",
                        at(middle, size, -1, -1, 0),
                        at(middle, size, 1, -0.9, 0.4),
                        at(middle, size, -0.6, 1, -0.3),
                        surface),
                new Cylinder(
                        "tube",
                        at(middle, size, 0.8, -1, -0.9),
                        at(middle, size, -0.5, 1, 0.1),
                        0.6 * size,
                        false,
                        surface),
                new Cone(
                        "funnel",
                        at(middle, size, -0.5, 1, 0.1),
                        at(middle, size, 0.8, -1, -0.9),
                        0.7 * size,
                        false,
                        surface));
    }

    /** All of them. */
    public static Stream<SceneObject> all(Vector3dc middle, double size, Surface surface) {
        return Stream.concat(closed(middle, size, surface), open(middle, size, surface));
    }

    /** What a sample is a sample of. */
    static Class<?> shape(SceneObject object) {
        return object instanceof Placed placed ? placed.object().getClass() : object.getClass();
    }

    private static Vector3d at(Vector3dc middle, double size, double x, double y, double z) {
        return new Vector3d(middle).fma(size, new Vector3d(x, y, z));
    }
}
