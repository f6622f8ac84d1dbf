package tompkins.ui.panel;

import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.surface.FrameWindow;
import tompkins.surface.GalileoWindow;
import tompkins.surface.LorentzWindow;
import tompkins.ui.editor.RecordForm;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.Wording;

/** The window in front of the lens: none, or one that can undo what the motion does to the picture. */
public final class WindowPanel extends Part {

    /** The kinds of window. */
    private enum Kind {
        NO_WINDOW,
        LORENTZ_WINDOW,
        GALILEO_WINDOW;

        static Kind of(Optional<FrameWindow> window) {
            return window.map(surface -> surface instanceof LorentzWindow ? LORENTZ_WINDOW : GALILEO_WINDOW)
                    .orElse(NO_WINDOW);
        }
    }

    private final StudioModel model;
    private final JComboBox<Kind> kinds = new JComboBox<>(Kind.values());
    private final JButton match = Buttons.of("window.match", this::matchCamera);
    private final Note note = Note.ofLines(2);
    private final JPanel details = Rows.column();
    private final Updating updating = new Updating();
    private Class<?> shownType;
    private RecordForm form;

    /** A panel for the window before the lens in the studio of a model, which follows its changes. */
    public WindowPanel(StudioModel model) {
        super(Rows.column());
        this.model = model;
        Naming.items(kinds, Wording::label);
        Naming.name(kinds, Texts.get("window.name"), Texts.get("window.tip"));
        kinds.addActionListener(event -> updating.unless(() -> choose((Kind) kinds.getSelectedItem())));
        panel.add(kinds, "wmin 0");
        panel.add(match);
        panel.add(note.component(), "wmin 0");
        panel.add(details, "wmin 0");
        model.follow(this::update);
    }

    private void choose(Kind kind) {
        Studio studio = model.studio();
        if (kind == Kind.of(FrontWindow.of(studio))) {
            return;
        }
        FrameWindow window = switch (kind) {
            case NO_WINDOW -> null;
            case LORENTZ_WINDOW -> LorentzWindow.DEFAULT.withVelocity(studio.velocity());
            case GALILEO_WINDOW -> GalileoWindow.DEFAULT.withVelocity(studio.velocity());
        };
        model.set(FrontWindow.with(studio, window));
    }

    private void matchCamera() {
        Studio studio = model.studio();
        FrontWindow.of(studio)
                .ifPresent(window -> model.set(FrontWindow.with(studio, window.withVelocity(studio.velocity()))));
    }

    private void update() {
        Optional<FrameWindow> window = FrontWindow.of(model.studio());
        boolean matches = FrontWindow.matches(model.studio());
        updating.during(() -> kinds.setSelectedItem(Kind.of(window)));
        match.setEnabled(window.isPresent() && !matches);
        note.setText(matches ? Texts.get("window.follows") : "");
        details.setVisible(window.isPresent());
        window.ifPresentOrElse(this::showDetails, () -> EntryField.in(details).forEach(EntryField::revert));
    }

    private void showDetails(FrameWindow window) {
        if (window.getClass() != shownType) {
            shownType = window.getClass();
            details.removeAll();
            form = new RecordForm(
                    shownType,
                    component -> true,
                    changed -> model.set(FrontWindow.with(model.studio(), (FrameWindow) changed)));
            details.add(form.component(), "wmin 0");
            details.revalidate();
        }
        form.show(window);
    }
}
