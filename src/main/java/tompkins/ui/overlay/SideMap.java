package tompkins.ui.overlay;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import javax.swing.UIManager;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Bounds;
import tompkins.ray.Ray;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.ui.picture.Overlay;
import tompkins.ui.picture.Picture;

/**
 * A small map of the scene, seen from its right side: z to the right and y up, in the scene frame at the time at which
 * the picture is taken. It shows boxes around the objects, the camera, its motion, and the directions between which
 * light comes into the middle column of the picture.
 */
public final class SideMap implements Overlay {

    /** The most boxes: more could not be distinguished. */
    private static final int MOST_BOXES = 2000;

    /** Sizes in sizes of the type. */
    private static final double WIDTH = 17;

    private static final double HEIGHT = 12;
    private static final double GAP = 0.9;

    /** Room around what is shown, as a share of it. */
    private static final double MARGIN = 0.12;

    private static final Color OBJECTS = new Color(150, 170, 200);
    private static final Color VIEW = new Color(255, 210, 90);
    private static final Color MOTION = new Color(120, 220, 140);

    private boolean shown;
    private List<Bounds> boxes = List.of();

    /** Paints the map from now on, or not. */
    public void setShown(boolean show) {
        shown = show;
    }

    @Override
    public void paint(Graphics2D graphics, Picture picture, Rectangle bounds, Rectangle visible, Rectangle free) {
        if (!shown) {
            return;
        }
        RenderPlan plan = picture.plan();
        boxes = plan.sceneBounds(MOST_BOXES);
        Font font = UIManager.getFont("small.font");
        double type = font.getSize2D();
        double width = Math.min(WIDTH * type, free.width * 0.4);
        double height = Math.min(HEIGHT * type, free.height * 0.4);
        Rectangle2D place = new Rectangle2D.Double(
                free.getMaxX() - width - GAP * type, free.getMaxY() - height - GAP * type, width, height);
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setComposite(AlphaComposite.SrcOver.derive(0.75f));
        g.setColor(Color.BLACK);
        g.fill(place);
        g.setComposite(AlphaComposite.SrcOver);
        g.clip(place);
        new Drawing(g, place, plan, font).draw();
        g.dispose();
    }

    /** The map of one picture. */
    private final class Drawing {

        private final Graphics2D g;
        private final Rectangle2D place;
        private final RenderPlan plan;
        private final Font font;
        private final Vector3d lens;
        private final AffineTransform toMap;

        Drawing(Graphics2D g, Rectangle2D place, RenderPlan plan, Font font) {
            this.g = g;
            this.place = place;
            this.plan = plan;
            this.font = font;
            lens = plan.lensInScene().position();
            toMap = toMap();
        }

        /** From z and y of the scene to the map: all boxes and the lens have room. */
        private AffineTransform toMap() {
            Rectangle2D all = new Rectangle2D.Double(lens.z, lens.y, 0, 0);
            for (Bounds box : boxes) {
                all.add(new Rectangle2D.Double(
                        box.minZ(), box.minY(), box.maxZ() - box.minZ(), box.maxY() - box.minY()));
            }
            double wide = Math.max(all.getWidth(), 1e-9);
            double high = Math.max(all.getHeight(), 1e-9);
            double share = 1 - 2 * MARGIN;
            double scale = Math.min(share * place.getWidth() / wide, share * place.getHeight() / high);
            AffineTransform map = AffineTransform.getTranslateInstance(place.getCenterX(), place.getCenterY());
            map.scale(scale, -scale);
            map.translate(-all.getCenterX(), -all.getCenterY());
            return map;
        }

        void draw() {
            g.setStroke(new BasicStroke(1));
            g.setColor(OBJECTS);
            for (Bounds box : boxes) {
                g.draw(toMap.createTransformedShape(new Rectangle2D.Double(
                        box.minZ(), box.minY(), box.maxZ() - box.minZ(), box.maxY() - box.minY())));
            }
            drawView();
            drawMotion();
            Point2D at = toMap.transform(new Point2D.Double(lens.z, lens.y), null);
            g.setColor(Color.WHITE);
            g.fill(new Ellipse2D.Double(at.getX() - 3, at.getY() - 3, 6, 6));
            g.setFont(font);
            g.setColor(OBJECTS);
            g.drawString("z \u2192, y \u2191", (float) place.getX() + 5, (float) (place.getMaxY() - 5));
        }

        /** The directions, in the scene, of the light at the upper and the lower edge of the picture. */
        private void drawView() {
            SpaceTimeTransformation sceneFromCamera = plan.studio().sceneFromCamera();
            g.setColor(VIEW);
            Vector2dc middle = plan.middle();
            // the lower edge itself may belong to the picture of another eye
            for (double row : new double[] {0, middle.y(), Math.nextDown(2 * middle.y())}) {
                Vector3dc look = plan.chiefDirection(middle.x(), row);
                Ray ray = sceneFromCamera.transform(Ray.from(0, 0, 0, look.x(), look.y(), look.z(), 0));
                g.setStroke(
                        row == middle.y()
                                ? new BasicStroke(
                                        1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, new float[] {4}, 0)
                                : new BasicStroke(1));
                drawLine(new Vector3d(ray.dx, ray.dy, ray.dz), place.getWidth() + place.getHeight());
            }
        }

        private void drawMotion() {
            Studio studio = plan.studio();
            if (!plan.isAtRest()) {
                g.setColor(MOTION);
                g.setStroke(new BasicStroke(3, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
                double length = studio.velocity().speed() * place.getHeight() / 4;
                drawLine(studio.velocity().direction(), length);
            }
        }

        /** A line from the lens along a direction, as long on the map as its projection. */
        private void drawLine(Vector3dc direction, double length) {
            Point2D at = toMap.transform(new Point2D.Double(lens.z, lens.y), null);
            Path2D line = new Path2D.Double();
            line.moveTo(at.getX(), at.getY());
            line.lineTo(at.getX() + length * direction.z(), at.getY() - length * direction.y());
            g.draw(line);
        }
    }
}
