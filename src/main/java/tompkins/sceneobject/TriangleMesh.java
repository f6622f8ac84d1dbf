package tompkins.sceneobject;

import java.util.stream.IntStream;
import org.joml.Vector3d;
import tompkins.math.Vectors;
import tompkins.primitive.FlatPrimitive;
import tompkins.primitive.Placement;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.MeshData;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/**
 * Triangles from an OBJ file, each flat. Coordinates: (0, 0) at the first corner of each triangle, (1, 0) and (0, 1) at
 * the others. Triangles without area are left out: no ray can meet them.
 */
@Meaning("Triangles from an OBJ file; (u, v) is (0, 0), (1, 0) and (0, 1) at the corners of each")
public record TriangleMesh(
        @Meaning("Name of the object") String description,

        @Meaning("The OBJ file, relative to the scene file") MeshData mesh,

        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** An octahedron. */
    public static final TriangleMesh DEFAULT = new TriangleMesh("mesh", MeshData.OCTAHEDRON, ColouredSurface.DEFAULT);

    /** Checks that nothing is missing, and that there is something to be seen. */
    public TriangleMesh {
        Require.present("description", description);
        Require.present("mesh", mesh);
        Require.present("surface", surface);
        if (IntStream.range(0, mesh.triangles()).noneMatch(triangle -> hasArea(mesh, triangle))) {
            throw new InvalidPropertyException(
                    "mesh", "triangles, at least one of them with an area", '"' + mesh.name() + '"');
        }
    }

    @Override
    public double primitiveCount() {
        return mesh.triangles();
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        for (int triangle = 0; triangle < mesh.triangles(); triangle++) {
            Vector3d first = corner(mesh, triangle, 0);
            Vector3d spanU = placement.vector(corner(mesh, triangle, 1).sub(first));
            Vector3d spanV = placement.vector(corner(mesh, triangle, 2).sub(first));
            // an area that is not a number is not left out: the primitive refuses it
            if (area(spanU, spanV) != 0) {
                collector.add(new FlatPrimitive(
                        this, surface, FlatPrimitive.Outline.TRIANGLE, placement.point(first), spanU, spanV));
            }
        }
    }

    private static Vector3d corner(MeshData mesh, int triangle, int corner) {
        return new Vector3d(
                mesh.coordinate(triangle, corner, 0),
                mesh.coordinate(triangle, corner, 1),
                mesh.coordinate(triangle, corner, 2));
    }

    private static boolean hasArea(MeshData mesh, int triangle) {
        Vector3d first = corner(mesh, triangle, 0);
        double area = area(
                corner(mesh, triangle, 1).sub(first), corner(mesh, triangle, 2).sub(first));
        return area > 0 && area < Double.POSITIVE_INFINITY;
    }

    private static double area(Vector3d spanU, Vector3d spanV) {
        return Vectors.cross(spanU, spanV).length();
    }
}
