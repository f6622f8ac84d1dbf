package tompkins.ui.overlay;

import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameRoute;
import tompkins.studio.LensEvent;
import tompkins.trace.RenderPlan;
import tompkins.world.FrameAppearance;
import tompkins.world.InertialFrame;

/** The boxes around the objects of a scene, as a map shows them, in coordinates of the scene. */
final class MappedBoxes {

    /** The most boxes: more could not be distinguished. */
    private static final int MOST = 2000;

    /** The last corner of a box, opposite the first. */
    private static final int LAST = 7;

    private final RenderPlan plan;
    private final MapAxis axis;
    private final Event lensInCamera;
    private final Event lens;
    private final Path2D now = new Path2D.Double();
    private final Path2D seen = new Path2D.Double();
    private final Path2D ways = new Path2D.Double();
    private final Rectangle2D around;
    private int count;

    /** The boxes for a picture. */
    MappedBoxes(RenderPlan plan, MapAxis axis) {
        this.plan = plan;
        this.axis = axis;
        lensInCamera = LensEvent.inCamera(plan.studio());
        lens = LensEvent.inScene(plan.studio());
        Vector3d place = lens.position();
        around = new Rectangle2D.Double(axis.right(place), axis.up(place), 0, 0);
        plan.world().frames().forEach(this::add);
    }

    /** Where the objects are when the picture is taken, by the clocks of the scene. */
    Path2D now() {
        return now;
    }

    /** Where moving objects were when the light left that the picture shows; what rests is seen where it is. */
    Path2D seen() {
        return seen;
    }

    /** From where each moving object was to where it is. */
    Path2D ways() {
        return ways;
    }

    /** Whether nothing moves. */
    boolean isStill() {
        return ways.getCurrentPoint() == null;
    }

    /** The rectangle around the lens and all objects, except those in which the lens is, such as a sky. */
    Rectangle2D around() {
        return around;
    }

    private void add(InertialFrame frame) {
        FrameAppearance light = new FrameAppearance(plan.studio(), frame.motion());
        for (Primitive primitive : frame.objects().primitives()) {
            Bounds bounds = primitive.allBounds();
            if (bounds != null && count < MOST) {
                count++;
                add(frame, light, bounds.moved(frame.origin().position()));
            }
        }
    }

    private void add(InertialFrame frame, FrameAppearance light, Bounds box) {
        Vector3d[] corners = box.corners();
        boolean shows = box.distance(light.fromCamera(lensInCamera).position()) > 0;
        if (frame.motion() == null) {
            Rectangle2D flat = new Rectangle2D.Double();
            flat.setFrameFromDiagonal(
                    axis.right(corners[0]), axis.up(corners[0]), axis.right(corners[LAST]), axis.up(corners[LAST]));
            now.append(flat, false);
            if (shows) {
                around.add(flat);
            }
            return;
        }
        FrameRoute toScene = frame.motion().toScene(plan.studio().transformation());
        Vector3d[] places = new Vector3d[corners.length];
        Vector3d[] left = new Vector3d[corners.length];
        for (int i = 0; i < corners.length; i++) {
            places[i] = toScene.place(corners[i], lens.time());
            left[i] = seen(toScene, light, corners[i]);
        }
        addEdges(now, places, shows);
        addEdges(seen, left, shows);
        Vector3d from = seen(toScene, light, box.centre());
        if (from != null) {
            Vector3d to = toScene.place(box.centre(), lens.time());
            ways.moveTo(axis.right(from), axis.up(from));
            ways.lineTo(axis.right(to), axis.up(to));
        }
    }

    /** Where a point of a moving frame was when its light left; null if none reaches the lens. */
    private Vector3d seen(FrameRoute toScene, FrameAppearance light, Vector3dc point) {
        Event event = light.seen(point, lensInCamera);
        return event == null ? null : toScene.transform(event).position();
    }

    /** Corners of a box whose numbers differ by one bit have an edge between them. */
    private void addEdges(Path2D path, Vector3d[] corners, boolean shows) {
        for (int corner = 0; corner < corners.length; corner++) {
            for (int bit = 1; bit < corners.length; bit *= 2) {
                if ((corner & bit) == 0 && corners[corner] != null && corners[corner | bit] != null) {
                    path.moveTo(axis.right(corners[corner]), axis.up(corners[corner]));
                    path.lineTo(axis.right(corners[corner | bit]), axis.up(corners[corner | bit]));
                }
            }
            if (shows && corners[corner] != null) {
                around.add(axis.right(corners[corner]), axis.up(corners[corner]));
            }
        }
    }
}
