package tompkins.ui.photograph;

import java.awt.Color;
import java.awt.Dimension;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Texts;

/** Says on a spoilt picture what is wrong with it, and offers a remedy. */
final class PictureNotice {

    private static final String AT_TOP = "[20%!][top]";
    private static final String IN_THE_MIDDLE = "[50%!][top]";

    private final StudioModel model;
    private final JPanel panel = new NoticePanel();
    private final Note problem = new Note("");
    private final JButton button = new JButton();

    /** Below what is written at the top of the picture; a ride writes more there. */
    private final MigLayout layout = new MigLayout("novisualpadding, insets 10, fill", "[center]", AT_TOP);

    private Studio noticed;
    private Remedy remedy;
    private Function<Picture, String> trouble = picture -> "";
    private Runnable back = () -> {};

    /** A notice that is hidden. */
    PictureNotice(StudioModel model, PictureCanvas canvas) {
        this.model = model;
        button.setName("notice.remedy");
        button.addActionListener(event -> apply());
        panel.add(problem.component(), "growx, wmin 0");
        panel.add(button, "alignx center, wmin 0");
        panel.setVisible(false);
        canvas.setLayout(layout);
        canvas.add(panel, "cell 0 1, wmin 0");
    }

    /**
     * Lets a ride say of its pictures why there is nothing to see.
     *
     * @param says gives a sentence, or nothing
     * @param home leads back
     */
    void setRide(Function<Picture, String> says, Runnable home) {
        trouble = says;
        back = home;
    }

    /** Shows what there is to say about the picture on the screen; about an incomplete one only a ride knows. */
    void show(Picture picture) {
        String said = trouble.apply(picture);
        layout.setRowConstraints(said.isEmpty() ? AT_TOP : IN_THE_MIDDLE);
        if (!said.isEmpty()) {
            noticed = picture.studio();
            remedy = null;
            problem.setText(said);
            button.setText(Texts.get("ride.home"));
            panel.setVisible(true);
        } else if (picture.complete()) {
            noticed = picture.studio();
            remedy = Remedy.of(picture).orElse(null);
            panel.setVisible(remedy != null);
            if (remedy != null) {
                problem.setText(remedy.problem());
                button.setText(remedy.action());
            }
        } else if (!picture.studio().equals(noticed)) {
            panel.setVisible(false);
        }
    }

    private void apply() {
        if (remedy == null) {
            panel.setVisible(false);
            back.run();
            return;
        }
        // the scene may have changed since the picture was taken
        if (model.studio().equals(noticed)) {
            panel.setVisible(false);
            model.set(remedy.studio());
        }
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
