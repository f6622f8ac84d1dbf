package tompkins.sceneobject;

import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import tompkins.math.Vectors;
import tompkins.primitive.FlatPrimitive;
import tompkins.primitive.Placement;
import tompkins.primitive.ShadedTriangle;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.MeshDetail;
import tompkins.ray.MeshMaterial;
import tompkins.ray.PixelPicture;
import tompkins.surface.ColouredSurface;
import tompkins.surface.PictureSurface;
import tompkins.surface.Surface;

/**
 * Triangles from an OBJ file, each flat. Coordinates: those of the file, or where it has none, (0, 0) at the first
 * corner of a triangle, (1, 0) and (0, 1) at the others. Triangles without area are left out: no ray can meet them.
 */
@Meaning(
        "Triangles from an OBJ file; (u, v) is what the file says, or (0, 0), (1, 0) and (0, 1) at the corners of each")
public record TriangleMesh(
        @Meaning("Name of the object") String description,

        @Meaning("The OBJ file, relative to the scene file") MeshData mesh,

        @Meaning("What it looks like where it has no material")
        Surface surface,

        @Meaning("Whether the materials of the OBJ file are shown; otherwise all of it has the surface")
        boolean materials)
        implements SceneObject {

    /** An octahedron. */
    public static final TriangleMesh DEFAULT =
            new TriangleMesh("mesh", MeshData.OCTAHEDRON, ColouredSurface.DEFAULT, true);

    /** Checks that there is something to be seen. */
    public TriangleMesh {
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
    public boolean isBody() {
        return mesh.isClosed();
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        MeshDetail detail = mesh.detail();
        List<MeshSurfaces> surfaces =
                detail.materials().stream().map(MeshSurfaces::of).toList();
        for (int triangle = 0; triangle < mesh.triangles(); triangle++) {
            Vector3d first = corner(mesh, triangle, 0);
            Vector3d spanU = placement.vector(corner(mesh, triangle, 1).sub(first));
            Vector3d spanV = placement.vector(corner(mesh, triangle, 2).sub(first));
            // an area that is not a number is not left out: the primitive refuses it
            if (area(spanU, spanV) != 0) {
                int material = materials ? detail.material(triangle) : -1;
                boolean textured = detail.hasTexture(triangle);
                Surface shown = material < 0 ? surface : surfaces.get(material).shown(textured);
                collector.add(
                        textured && shown.usesCoordinates() || detail.hasNormals(triangle)
                                ? new ShadedTriangle(
                                        this, shown, placement.point(first), spanU, spanV, detail, triangle, placement)
                                : new FlatPrimitive(
                                        this,
                                        shown,
                                        FlatPrimitive.Outline.TRIANGLE,
                                        placement.point(first),
                                        spanU,
                                        spanV));
            }
        }
    }

    /** What a material looks like with a picture, and where it has no place in one. */
    private record MeshSurfaces(Surface withPicture, Surface plain) {

        static MeshSurfaces of(MeshMaterial material) {
            Colour colour = material.diffuse();
            Surface plain = new ColouredSurface(colour, material.specular());
            if (material.opacity() < 1) {
                float[] pixel = {
                    (float) colour.red(), (float) colour.green(), (float) colour.blue(), (float) material.opacity()
                };
                PixelPicture sheet = new PixelPicture(material.name(), 1, 1, pixel, new byte[0]);
                plain = new PictureSurface(sheet, false, true);
            }
            return new MeshSurfaces(
                    material.picture() == null ? plain : new PictureSurface(material.picture(), false, true), plain);
        }

        Surface shown(boolean textured) {
            return textured ? withPicture : plain;
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
