package tompkins.sceneobject;

import org.joml.Matrix3d;
import org.joml.Vector2i;
import org.joml.Vector2ic;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Placement;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;

/**
 * Copies of an object at the places in the scene where the camera takes its sharp picture: for each point of a grid
 * that is fixed to the camera, the place of the event at which the central ray of the lens photographs it. They depend
 * on the camera's velocity and shutter; with a shutter that images stigmatically the camera sees the copies as a sharp,
 * regular grid (Courtial et al. 2016, Fig. 3).
 */
@Meaning(
        "Copies of an object at the places that the moving camera photographs as a regular grid, as in Fig. 3 of the paper;"
                + " windows and glass before the lens are not taken into account")
public record ImagePointGrid(
        @Meaning("Name of the object") String description,

        @Meaning("The object that is copied; its origin goes to each place")
        SceneObject object,

        @Meaning(value = "First corner of the grid, in the camera frame", unit = "length", place = true)
        Vector3dc corner,

        @Meaning(value = "From that corner along the rows of the grid", unit = "length")
        Vector3dc spanU,

        @Meaning(value = "From that corner along the columns of the grid", unit = "length")
        Vector3dc spanV,

        @Meaning("Number of points along the rows and along the columns, at most 1000000 in all")
        Vector2ic points)
        implements SceneObject {

    /** The 81 places of the paper's Fig. 3. */
    public static final ImagePointGrid DEFAULT = new ImagePointGrid(
            "image points",
            new Sphere("ball", new Vector3d(), 0.025, ColouredSurface.DEFAULT),
            new Vector3d(-1, -1, 10),
            new Vector3d(2, 0, 0),
            new Vector3d(0, 2, 0),
            new Vector2i(9, 9));

    /** Checks all values. */
    public ImagePointGrid {
        corner = Require.finite("corner", corner);
        spanU = Require.finite("spanU", spanU);
        spanV = Require.finite("spanV", spanV);
        points = new Vector2i(points);
        if (points.x() < 1 || points.y() < 1 || (long) points.x() * points.y() > 1_000_000) {
            throw new InvalidPropertyException(
                    "points",
                    "1 or more in each direction, at most 1000000 in all",
                    "[" + points.x() + ", " + points.y() + "]");
        }
    }

    @Override
    public double primitiveCount() {
        return (double) points.x() * points.y() * object.primitiveCount();
    }

    @Override
    public boolean moves() {
        return object.moves();
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        // copies of copies of nothing would take forever, too
        if (object.primitiveCount() == 0) {
            return;
        }
        for (int i = 0; i < points.x(); i++) {
            for (int j = 0; j < points.y(); j++) {
                Vector3d point = new Vector3d(corner)
                        .add(new Vector3d(spanU).mul(fraction(i, points.x())))
                        .add(new Vector3d(spanV).mul(fraction(j, points.y())));
                Vector3dc place = collector.imagePoint(point);
                // a point whose light never crosses the shutter is photographed nowhere
                if (place.isFinite()) {
                    object.addTo(collector, placement.after(new Placement(1, new Matrix3d(), place)));
                }
            }
        }
    }

    private static double fraction(int index, int count) {
        return count == 1 ? 0.5 : index / (count - 1.0);
    }
}
