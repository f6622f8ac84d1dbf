package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector3i;
import org.joml.Vector3ic;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Placement;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** Rods along all three axes through the points of a rectangular grid, as in the paper's figures. */
@Meaning("Rods along all three axes through the points of a rectangular grid, at most 4000000")
public record CylinderLattice(
        @Meaning("Name of the object") String description,

        @Meaning(value = "The grid point with the smallest coordinates", unit = "length", place = true)
        Vector3dc from,

        @Meaning(value = "The grid point with the largest coordinates", unit = "length", place = true)
        Vector3dc to,

        @Meaning("Number of grid points along x, y and z, each 2 or more")
        Vector3ic points,

        @Meaning(value = "Radius of the rods", unit = "length")
        double radius,

        @Meaning("What the rods along x look like") Surface surfaceAlongX,
        @Meaning("What the rods along y look like") Surface surfaceAlongY,
        @Meaning("What the rods along z look like") Surface surfaceAlongZ)
        implements SceneObject {

    /** Most rods of a lattice, so that a typing mistake does not fill the memory. */
    private static final long MOST_RODS = 4_000_000;

    /** The lattice of the paper's figures, from class {@code ShutterModelFocussing} of Dr TIM. */
    public static final CylinderLattice DEFAULT = new CylinderLattice(
            "lattice",
            new Vector3d(-1.5, -1.5, -1),
            new Vector3d(1.5, 1.5, 10),
            new Vector3i(4, 4, 12),
            0.02,
            shiny(0, 0, 1),
            shiny(0, 1, 0),
            shiny(1, 0, 0));

    /** Checks all values. */
    public CylinderLattice {
        from = Require.finite("from", from);
        to = Require.finite("to", to);
        if (!(to.x() > from.x() && to.y() > from.y() && to.z() > from.z())) {
            throw new InvalidPropertyException(
                    "to", "above " + Require.text(from) + " in every coordinate", Require.text(to));
        }
        points = new Vector3i(points);
        if (points.x() < 2 || points.y() < 2 || points.z() < 2 || rods(points) > MOST_RODS) {
            throw new InvalidPropertyException(
                    "points",
                    "2 or more along each axis, for at most " + MOST_RODS + " rods",
                    "[" + points.x() + ", " + points.y() + ", " + points.z() + "]");
        }
        Require.positive("radius", radius);
    }

    private static Surface shiny(double red, double green, double blue) {
        return new ColouredSurface(new Colour(red, green, blue), Colour.WHITE);
    }

    private static double rods(Vector3ic points) {
        double x = points.x();
        double y = points.y();
        double z = points.z();
        return x * y + y * z + z * x;
    }

    @Override
    public double primitiveCount() {
        return rods(points);
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        addRods(collector, placement, 2, 0, 1, surfaceAlongZ);
        addRods(collector, placement, 0, 2, 1, surfaceAlongX);
        addRods(collector, placement, 1, 0, 2, surfaceAlongY);
    }

    private void addRods(
            PrimitiveCollector collector, Placement placement, int along, int outer, int inner, Surface surface) {
        for (int i = 0; i < points.get(outer); i++) {
            for (int j = 0; j < points.get(inner); j++) {
                Vector3d start = new Vector3d(from);
                start.setComponent(outer, coordinate(outer, i));
                start.setComponent(inner, coordinate(inner, j));
                Vector3d end = new Vector3d(start);
                end.setComponent(along, to.get(along));
                collector.add(new CylinderPrimitive(this, surface, start, end, radius, true, placement));
            }
        }
    }

    private double coordinate(int axis, int index) {
        return from.get(axis) + index * (to.get(axis) - from.get(axis)) / (points.get(axis) - 1);
    }
}
