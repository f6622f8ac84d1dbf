package tompkins.ui.photograph;

import java.awt.Color;
import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import tompkins.camera.Camera;
import tompkins.image.LinearImage;
import tompkins.property.Descriptions;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Texts;

/** Says on a spoilt picture what is wrong with it, and offers a remedy. */
final class PictureNotice {

    /** The largest share of pixels that may be brighter than white in a good picture. */
    private static final double MOST_WHITE = 0.1;

    private final StudioModel model;
    private final JPanel panel = new NoticePanel();
    private final Note problem = new Note("");
    private final JButton button = new JButton();

    private Studio noticed;

    /** What the button does. */
    private Runnable help = () -> {};

    /** A notice that is hidden. */
    PictureNotice(StudioModel model, PictureCanvas canvas) {
        this.model = model;
        button.setName("notice.remedy");
        button.addActionListener(event -> help.run());
        panel.add(problem.component(), "growx, wmin 0");
        panel.add(button, "alignx center, wmin 0");
        panel.setVisible(false);
        // below what is written at the top of the picture
        canvas.setLayout(new MigLayout("novisualpadding, insets 10, fill", "[center]", "[20%!][top]"));
        canvas.add(panel, "cell 0 1, wmin 0");
    }

    /** Shows the messages about the picture on the screen; about an incomplete one nothing is known. */
    void show(Picture picture) {
        if (picture.complete()) {
            noticed = picture.studio();
            offerRemedy(picture);
        } else if (!picture.studio().equals(noticed)) {
            panel.setVisible(false);
        }
    }

    private void offer(String text, String action, Runnable helps) {
        problem.setText(text);
        button.setText(action);
        help = helps;
        panel.setVisible(true);
    }

    /** Offers what puts a spoilt picture right at once. */
    private void offerRemedy(Picture picture) {
        Studio studio = picture.studio();
        switch (picture.flaw()) {
            case NONE -> panel.setVisible(false);
            case BURNT -> {
                int stops = stopsTooMany(picture.image());
                Camera camera = studio.camera();
                offer(
                        Texts.get("remedy.burnt"),
                        stops == 1 ? Texts.get("remedy.darkerByOne") : Texts.get("remedy.darker", stops),
                        () -> replaceBy(studio.withCamera(
                                Descriptions.with(camera, "exposureStops", camera.exposureStops() - stops))));
            }
            case EMPTY ->
                FrontWindow.of(studio)
                        .ifPresentOrElse(
                                window -> offer(
                                        Texts.get("remedy.empty"),
                                        Texts.get("remedy.noWindow"),
                                        () -> replaceBy(FrontWindow.with(studio, null))),
                                () -> panel.setVisible(false));
        }
    }

    private void replaceBy(Studio better) {
        // the scene may have changed since the picture was taken
        if (model.studio().equals(noticed)) {
            panel.setVisible(false);
            model.set(better);
        }
    }

    /** By how many whole stops the exposure has to go down until hardly a pixel is brighter than white. */
    static int stopsTooMany(LinearImage image) {
        float[] rgb = image.rgb();
        int[] brighter = new int[Float.MAX_EXPONENT + 2];
        for (int i = 0; i < rgb.length; i += 3) {
            float brightest = Math.max(rgb[i], Math.max(rgb[i + 1], rgb[i + 2]));
            if (brightest > 1) {
                // as many stops as halvings until it is at most 1
                int stops = Math.getExponent(brightest);
                brighter[brightest > Math.scalb(1f, stops) ? stops + 1 : stops]++;
            }
        }
        int most = (int) (MOST_WHITE * rgb.length / 3);
        int stops = brighter.length - 1;
        for (int white = brighter[stops]; stops > 0 && white <= most; white += brighter[stops]) {
            stops--;
        }
        return stops;
    }

    @SuppressWarnings("serial") // never written to a stream
    private static final class NoticePanel extends JPanel {

        /** Its width if the canvas has room for it, in sizes of the type. */
        private static final double WIDTH = 26;

        NoticePanel() {
            super(new MigLayout("novisualpadding, insets 6 8 6 8, wrap 1, gap 0 6", "[grow,fill]"));
        }

        @Override
        public Dimension getPreferredSize() {
            return new Dimension(Look.pixels(WIDTH), super.getPreferredSize().height);
        }

        @Override
        public void updateUI() {
            super.updateUI();
            Color line = UIManager.getColor("Tompkins.line");
            setBorder(BorderFactory.createLineBorder(line == null ? Color.GRAY : line));
        }
    }
}
