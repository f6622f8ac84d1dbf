package tompkins.ray;

import java.util.Arrays;
import java.util.List;

/**
 * What triangles of a mesh have besides their corners. Immutable: the arrays are handed over and must not be changed
 * afterwards.
 *
 * @param textureCoordinates u and v in a picture, two numbers each
 * @param textureCorners for each corner of each triangle the number of its texture coordinates, -1 for none; empty if
 *     there are none
 * @param normals x, y and z of unit normals
 * @param normalCorners for each corner of each triangle the number of its normal, -1 for none; empty if there are none
 * @param materials the materials of the mesh
 * @param materialOf for each triangle the number of its material, -1 for none; empty if there are none
 * @param notes what the file says that is not shown, one sentence for each kind
 */
public record MeshDetail(
        double[] textureCoordinates,
        int[] textureCorners,
        double[] normals,
        int[] normalCorners,
        List<MeshMaterial> materials,
        int[] materialOf,
        List<String> notes) {

    /** Nothing. */
    public static final MeshDetail NONE =
            new MeshDetail(new double[0], new int[0], new double[0], new int[0], List.of(), new int[0], List.of());

    /** Whether a triangle has texture coordinates at each corner. */
    public boolean hasTexture(int triangle) {
        return has(textureCorners, triangle);
    }

    /** Whether a triangle has a normal at each corner. */
    public boolean hasNormals(int triangle) {
        return has(normalCorners, triangle);
    }

    private static boolean has(int[] corners, int triangle) {
        int at = 3 * triangle;
        return corners.length > 0 && corners[at] >= 0 && corners[at + 1] >= 0 && corners[at + 2] >= 0;
    }

    /** The number of the material of a triangle, -1 if it has none. */
    public int material(int triangle) {
        return materialOf.length == 0 ? -1 : materialOf[triangle];
    }

    /** A coordinate in a picture: 0 for u, 1 for v. */
    public double texture(int triangle, int corner, int axis) {
        return textureCoordinates[2 * textureCorners[3 * triangle + corner] + axis];
    }

    /** A component of the normal at a corner: 0 for x, 1 for y, 2 for z. */
    public double normal(int triangle, int corner, int axis) {
        return normals[3 * normalCorners[3 * triangle + corner] + axis];
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof MeshDetail detail
                && materials.equals(detail.materials)
                && Arrays.equals(materialOf, detail.materialOf)
                && Arrays.equals(textureCorners, detail.textureCorners)
                && Arrays.equals(textureCoordinates, detail.textureCoordinates)
                && Arrays.equals(normalCorners, detail.normalCorners)
                && Arrays.equals(normals, detail.normals);
    }

    @Override
    public int hashCode() {
        return materials.hashCode() * 31 + textureCorners.length;
    }
}
