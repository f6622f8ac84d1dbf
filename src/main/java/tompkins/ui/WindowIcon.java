package tompkins.ui;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.LinearGradientPaint;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import tompkins.ui.widget.Drawing;

/** The sign of the program: waves of light around something that moves to the right, blue ahead and red behind. */
final class WindowIcon {

    /** Sizes that desktops ask for, in pixels. */
    private static final int[] SIZES = {16, 24, 32, 48, 64, 128};

    private static final Color BACKGROUND = new Color(0x14202e);
    private static final Color BEHIND = new Color(0xff5a3c);
    private static final Color BESIDE = new Color(0xffe9a8);
    private static final Color AHEAD = new Color(0x5aa8ff);

    /** Speed of the source of the waves. */
    private static final double SPEED = 0.55;

    private static final int WAVES = 3;

    private WindowIcon() {}

    /** The icon in all sizes. */
    static List<Image> images() {
        return IntStream.of(SIZES).<Image>mapToObj(WindowIcon::image).toList();
    }

    static BufferedImage image(int size) {
        BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = image.createGraphics();
        Drawing.smooth(g);
        // drawn in a square of side 1
        g.scale(size, size);
        g.setColor(BACKGROUND);
        g.fill(new RoundRectangle2D.Double(0, 0, 1, 1, 0.25, 0.25));
        g.setPaint(new LinearGradientPaint(
                0.1f, 0, 0.9f, 0, new float[] {0, 0.55f, 1}, new Color[] {BEHIND, BESIDE, AHEAD}));
        g.setStroke(new BasicStroke(0.07f));
        double largest = 0.38;
        double source = 0.5 + SPEED * largest;
        for (int wave = 1; wave <= WAVES; wave++) {
            double radius = largest * wave / WAVES;
            g.draw(Drawing.circle(source - SPEED * radius, 0.5, radius));
        }
        g.setColor(Color.WHITE);
        g.fill(Drawing.circle(source, 0.5, 0.05));
        g.dispose();
        return image;
    }
}
