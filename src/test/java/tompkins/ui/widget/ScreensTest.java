package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.image.ColorModel;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import tompkins.ui.NeedsDisplay;

class ScreensTest {

    private static final Rectangle PROJECTOR = new Rectangle(1920, -100, 1024, 768);

    /** A screen beside the first one, without task bars. */
    private static final class Projector extends GraphicsConfiguration {

        @Override
        public GraphicsDevice getDevice() {
            return null;
        }

        @Override
        public ColorModel getColorModel() {
            return ColorModel.getRGBdefault();
        }

        @Override
        public ColorModel getColorModel(int transparency) {
            return getColorModel();
        }

        @Override
        public AffineTransform getDefaultTransform() {
            return new AffineTransform();
        }

        @Override
        public AffineTransform getNormalizingTransform() {
            return new AffineTransform();
        }

        @Override
        public Rectangle getBounds() {
            return new Rectangle(PROJECTOR);
        }
    }

    @Test
    @NeedsDisplay
    @SuppressWarnings("serial") // never written to a stream
    void theRoomIsOnTheScreenWhereTheWindowIs() {
        JPanel there = new JPanel() {
            @Override
            public GraphicsConfiguration getGraphicsConfiguration() {
                return new Projector();
            }
        };
        assertThat(Screens.room(there)).isEqualTo(PROJECTOR);
    }
}
