package tompkins.ui.overlay;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import javax.swing.UIManager;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.NumberText;
import tompkins.ray.Ray;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.LensEvent;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.RenderPlan;
import tompkins.ui.picture.Overlay;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Drawing;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Texts;

/**
 * A map of the scene along one of its axes, in the scene frame at the time at which the picture is taken. It shows
 * boxes around the objects where they are now, and for moving ones where they were when the light left that is seen
 * now; the camera, its motion, and the directions from which light comes into the picture. Circles show the backward
 * light cone of the lens: where light was some units of time ago that arrives now.
 */
public final class SceneMap implements Overlay {

    /** Sizes in sizes of the type, and the most of the picture that it takes. */
    private static final double WIDTH = 34;

    private static final double HEIGHT = 26;
    private static final double SHARE = 0.45;
    private static final double GAP = 0.9;

    /** Room around what is shown, as a share of it. */
    private static final double MARGIN = 0.1;

    /** The width of a map on which there is nothing but the lens. */
    private static final double EMPTY = 10;

    /** About so many circles, and at most so many, are in the larger side of the map. */
    private static final int CIRCLES = 4;

    private static final int MOST_CIRCLES = 40;

    private static final Color NOW = new Color(150, 170, 200);
    private static final Color SEEN = new Color(255, 150, 90);
    private static final Color LIGHT = new Color(255, 255, 255, 90);
    private static final Color VIEW = new Color(255, 210, 90);
    private static final Color MOTION = new Color(120, 220, 140);

    private static final BasicStroke FINE = new BasicStroke(1);
    private static final BasicStroke DASHED =
            new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, new float[] {4}, 0);

    private Optional<MapAxis> axis = Optional.empty();

    /** Paints the map along an axis from now on, or none. */
    public void setShown(Optional<MapAxis> along) {
        axis = along;
    }

    @Override
    public void paint(Graphics2D graphics, Picture picture, Rectangle bounds, Rectangle visible, Rectangle free) {
        if (axis.isEmpty()) {
            return;
        }
        Font font = UIManager.getFont("small.font");
        double type = font.getSize2D();
        double width = Math.min(WIDTH * type, free.width * SHARE);
        double height = Math.min(HEIGHT * type, free.height * SHARE);
        Rectangle2D place = new Rectangle2D.Double(
                free.getMaxX() - width - GAP * type, free.getMaxY() - height - GAP * type, width, height);
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        Drawing.smooth(g);
        g.setComposite(AlphaComposite.SrcOver.derive(0.75f));
        g.setColor(Color.BLACK);
        g.fill(place);
        g.setComposite(AlphaComposite.SrcOver);
        g.clip(place);
        g.setFont(font);
        new Sheet(g, place, picture.plan(), axis.get()).draw();
        g.dispose();
    }

    /** The map of one picture. */
    private static final class Sheet {

        private final Graphics2D g;
        private final Rectangle2D place;
        private final RenderPlan plan;
        private final MapAxis axis;
        private final MappedBoxes boxes;
        private final Vector3d lens;
        private final AffineTransform toMap;

        Sheet(Graphics2D g, Rectangle2D place, RenderPlan plan, MapAxis axis) {
            this.g = g;
            this.place = place;
            this.plan = plan;
            this.axis = axis;
            boxes = new MappedBoxes(plan, axis);
            lens = LensEvent.inScene(plan.studio()).position();
            toMap = toMap();
        }

        /** From the scene to the map: all boxes and the lens have room. */
        private AffineTransform toMap() {
            Rectangle2D all = boxes.around();
            boolean lensAlone = all.getWidth() == 0 && all.getHeight() == 0;
            double wide = lensAlone ? EMPTY : Math.max(all.getWidth(), 1e-9);
            double high = Math.max(all.getHeight(), 1e-9);
            double share = 1 - 2 * MARGIN;
            double scale = Math.min(share * place.getWidth() / wide, share * place.getHeight() / high);
            AffineTransform map = AffineTransform.getTranslateInstance(place.getCenterX(), place.getCenterY());
            map.scale(scale, -scale);
            map.translate(-all.getCenterX(), -all.getCenterY());
            return map;
        }

        void draw() {
            drawLightCone();
            draw(NOW, FINE, boxes.now());
            draw(SEEN, FINE, boxes.seen());
            draw(SEEN, DASHED, boxes.ways());
            drawView();
            drawMotion();
            Point2D at = at(lens);
            g.setColor(Color.WHITE);
            g.fill(Drawing.circle(at.getX(), at.getY(), 3));
            float left = (float) place.getX() + 5;
            g.setColor(NOW);
            g.drawString(axis.names(), left, (float) (place.getMaxY() - 5));
            if (!boxes.isStill()) {
                int line = g.getFontMetrics().getHeight();
                float top = (float) place.getY() + line;
                g.drawString(Texts.get("map.now"), left, top);
                g.setColor(SEEN);
                g.drawString(Texts.get("map.seen"), left, top + line);
            }
        }

        private void draw(Color colour, BasicStroke stroke, Shape inScene) {
            g.setColor(colour);
            g.setStroke(stroke);
            g.draw(toMap.createTransformedShape(inScene));
        }

        private Point2D at(Vector3dc point) {
            return toMap.transform(new Point2D.Double(axis.right(point), axis.up(point)), null);
        }

        /** Circles, each with the time since light left it; a bar with a length where nothing is seen by light. */
        private void drawLightCone() {
            double scale = toMap.getScaleX();
            double step = Numbers.niceFloor(Math.max(place.getWidth(), place.getHeight()) / scale / CIRCLES);
            Studio studio = plan.studio();
            Point2D at = at(lens);
            float bottom = (float) (place.getMaxY() - 5);
            if (studio.view() == View.MEASURED) {
                double right = place.getMaxX() - 8;
                g.setColor(NOW);
                g.setStroke(new BasicStroke(2));
                g.draw(new Line2D.Double(right - step * scale, bottom, right, bottom));
                write(Texts.get("map.units", NumberText.of(step)), right - step * scale, bottom - 5);
                return;
            }
            // light of a Galilean world goes with the camera
            Vector3d flow = studio.transformation() == TransformationLaw.GALILEAN
                    ? studio.velocity().direction().mul(-studio.velocity().speed(), new Vector3d())
                    : new Vector3d();
            for (int i = 1; i <= MOST_CIRCLES; i++) {
                double time = i * step;
                Point2D centre = at(flow.mul(time, new Vector3d()).add(lens));
                Shape circle = Drawing.circle(centre.getX(), centre.getY(), time * scale);
                g.setColor(LIGHT);
                g.setStroke(FINE);
                g.draw(circle);
                g.setColor(NOW);
                String ago = Texts.get("map.ago", NumberText.of(NumberText.rounded(time, 6)));
                write(ago, at.getX() + 4, centre.getY() - time * scale - 2);
                write(ago, at.getX() + 4, centre.getY() + time * scale - 2);
            }
        }

        /** Writes what has room, beside the names of the axes. */
        private void write(String text, double x, double y) {
            double right = x + g.getFontMetrics().stringWidth(text);
            double top = y - g.getFont().getSize2D();
            if (right < place.getMaxX() && top > place.getY() && y < place.getMaxY()) {
                g.drawString(text, (float) x, (float) y);
            }
        }

        /** The directions, in the scene, of the light at two edges of the picture and in its middle. */
        private void drawView() {
            Vector2dc middle = plan.middle();
            boolean upright = axis == MapAxis.SIDE;
            for (int side = -1; side <= 1; side++) {
                // the far edge itself may belong to the picture of another eye
                double halves = side == 1 ? Math.nextDown(2.0) : side + 1;
                Vector3dc look = plan.chiefDirection(
                        upright ? middle.x() : halves * middle.x(), upright ? halves * middle.y() : middle.y());
                Ray ray = plan.studio().sceneFromCamera().transform(Ray.from(0, 0, 0, look.x(), look.y(), look.z(), 0));
                g.setColor(VIEW);
                g.setStroke(side == 0 ? DASHED : FINE);
                drawLine(new Vector3d(ray.dx, ray.dy, ray.dz), place.getWidth() + place.getHeight());
            }
        }

        private void drawMotion() {
            Studio studio = plan.studio();
            if (!plan.isAtRest()) {
                g.setColor(MOTION);
                g.setStroke(new BasicStroke(3, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
                drawLine(studio.velocity().direction(), studio.velocity().speed() * place.getHeight() / 4);
            }
        }

        /** A line from the lens along a direction, as long on the map as its projection. */
        private void drawLine(Vector3dc direction, double length) {
            Point2D at = at(lens);
            Path2D line = new Path2D.Double();
            line.moveTo(at.getX(), at.getY());
            line.lineTo(at.getX() + length * axis.right(direction), at.getY() - length * axis.up(direction));
            g.draw(line);
        }
    }
}
