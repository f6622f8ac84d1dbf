package tompkins.ui.panel;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.util.HashMap;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.ListCellRenderer;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import tompkins.property.Descriptions;
import tompkins.property.Require;
import tompkins.shutter.Shutter;
import tompkins.spacetime.Event;
import tompkins.studio.Studio;
import tompkins.ui.editor.RecordForm;
import tompkins.ui.model.Shutters;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.NumberRow;
import tompkins.ui.number.SceneSize;
import tompkins.ui.widget.CardPanel;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.TinyDrawing;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.Wording;

/** Where the shutter is, when and how it opens, and where the aperture is in the scene then. */
public final class ShutterPanel extends Part {

    private final StudioModel model;
    private final SceneSize size = new SceneSize();
    private final JComboBox<Class<?>> models = new JComboBox<>();
    private final Updating updating = new Updating();
    private final Note note = Note.ofLines(2);
    private final JPanel details = Rows.column();
    private final Note refused = Note.ofLines(1);
    private final JPanel timeRow = Rows.panel();
    private final ShutterTimingPanel timing;

    /** The own numbers of each model, in the height of the highest, so that nothing below them moves. */
    private final CardPanel parameters = new CardPanel();

    private final Map<Class<?>, RecordForm> forms = new HashMap<>();
    private Class<?> shownModel;
    private Shutter replaced;
    private Shutter replacement;

    /** A panel for the shutter of the studio in a model, which follows its changes. */
    public ShutterPanel(StudioModel model) {
        super(Rows.column());
        this.model = model;
        Descriptions.members(Shutter.class).forEach(models::addItem);
        Naming.name(models, Texts.get("shutter.name"), "");
        Naming.items(models, Wording::label);
        models.setRenderer(new ModelRenderer());
        models.setMaximumRowCount(models.getItemCount());
        models.addActionListener(event -> updating.unless(this::choose));
        NumberRow.Quantity time = new NumberRow.Quantity(
                "openingTime",
                Texts.get("shutter.timeTip"),
                ShutterPanel::openingTime,
                (studio, value) -> withShutter(shutter().openedAt(Require.finite("openingTime", value))),
                size::times);
        new NumberRow(model, time, NumberKind.DOUBLE, note).addTo(timeRow);
        timing = new ShutterTimingPanel(model, size);
        timing.addTo(timeRow, note);
        details.add(timing.component(), "wmin 0");
        details.add(parameters.component(), "wmin 0");
        details.add(refused.component(), "wmin 0");
        panel.add(models, "wmin 0");
        Descriptions.members(Shutter.class).forEach(this::addModel);
        panel.add(timeRow, "wmin 0, hidemode 0");
        panel.add(note.component(), "wmin 0");
        model.follow(this::update);
    }

    /** Shows the opening time alone, or all of the shutter. */
    public void setBrief(boolean brief) {
        if (models.isVisible() != brief) {
            return;
        }
        models.setVisible(!brief);
        timing.setBrief(brief);
        // the name above slider and field, where there is little room beside them
        MigLayout rows = (MigLayout) timeRow.getLayout();
        rows.setComponentConstraints(timeRow.getComponent(0), brief ? "span" : "");
        rows.setComponentConstraints(timeRow.getComponent(1), (brief ? "span 2, " : "") + "growx, wmin 40");
    }

    /** NaN if the shutter has none. */
    private static double openingTime(Studio studio) {
        Shutter shutter = studio.camera().shutter();
        return shutter.hasOpeningTime() ? shutter.openingTime() : Double.NaN;
    }

    /** Further numbers of the shutter, such as where it is. */
    public JComponent details() {
        return details;
    }

    private Shutter shutter() {
        return model.studio().camera().shutter();
    }

    private Studio withShutter(Shutter shutter) {
        return model.studio().withCamera(model.studio().camera().withShutter(shutter));
    }

    private void choose() {
        Class<?> chosen = (Class<?>) models.getSelectedItem();
        if (chosen != shownModel) {
            note.attempt(() -> replaceBy(chosen));
            // back to the model of before if the camera cannot have this one
            updating.during(() -> models.setSelectedItem(shownModel));
        }
    }

    /** Replaces the shutter. One without an opening time takes that of the last shutter that had one. */
    private void replaceBy(Class<?> chosen) {
        boolean forgotten = !shutter().hasOpeningTime() && shutter() == replacement;
        Shutter before = forgotten ? replaced : shutter();
        Studio next = Shutters.replaced(withShutter(before), chosen);
        replaced = before;
        replacement = next.camera().shutter();
        model.set(next);
    }

    private void update() {
        Shutter shutter = shutter();
        if (shutter.getClass() != shownModel) {
            // what was typed for the previous model is removed with it
            EntryField.in(details).forEach(EntryField::revert);
            EntryField.in(timeRow).forEach(EntryField::revert);
            shownModel = shutter.getClass();
            updating.during(() -> models.setSelectedItem(shownModel));
            Naming.tip(models, Wording.meaning(shownModel));
            parameters.show(shownModel);
        }
        timeRow.setVisible(shutter.hasOpeningTime());
        timing.update();
        forms.get(shownModel).show(shutter);
    }

    private void addModel(Class<?> type) {
        RecordForm form = new RecordForm(
                type,
                component -> !component.getName().equals("openingTime"),
                refused,
                changed -> model.set(withShutter((Shutter) changed)));
        forms.put(type, form);
        parameters.add(type, form.component());
    }

    /** Shows where the centre of the aperture is in the scene frame when the picture is taken. */
    public void showPlace(Event lensInScene) {
        note.setUsual(Texts.get("shutter.place", Numbers.brief(lensInScene)));
    }

    /** A drawing, the name, and in the list a line that says what the model does. */
    private static final class ModelRenderer implements ListCellRenderer<Class<?>> {

        /** Width of a line in sizes of the type, so that it fits into the list beneath the narrowest panel. */
        private static final double LINE = 13;

        private final JPanel cell = new JPanel(new BorderLayout(8, 0));
        private final JPanel words = new JPanel(new BorderLayout(0, 2));
        private final JLabel icon = new JLabel();
        private final JLabel name = new JLabel();
        private final JTextArea line = new JTextArea();

        ModelRenderer() {
            words.setOpaque(false);
            line.setOpaque(false);
            line.setLineWrap(true);
            line.setWrapStyleWord(true);
            words.add(name, BorderLayout.CENTER);
            words.add(line, BorderLayout.SOUTH);
            cell.setBorder(BorderFactory.createEmptyBorder(4, 4, 4, 4));
            cell.add(icon, BorderLayout.WEST);
            cell.add(words, BorderLayout.CENTER);
        }

        @Override
        public Component getListCellRendererComponent(
                JList<? extends Class<?>> list, Class<?> model, int index, boolean selected, boolean focused) {
            boolean inList = index >= 0;
            boolean marked = inList && selected;
            Color ink = marked ? list.getSelectionForeground() : list.getForeground();
            icon.setIcon(TinyDrawing.of(TinyDrawing.name(model), 64, 28, marked ? ink : null));
            name.setText(model == null ? "" : Wording.label(model));
            cell.getAccessibleContext().setAccessibleName(name.getText());
            line.setVisible(inList);
            line.setText(inList ? Wording.meaning(model) : "");
            cell.setOpaque(inList);
            cell.setBackground(marked ? list.getSelectionBackground() : list.getBackground());
            name.setForeground(ink);
            line.setForeground(ink);
            name.setFont(UIManager.getFont("Label.font"));
            line.setFont(UIManager.getFont("small.font"));
            // the height of wrapped text is known only when its width is
            line.setSize(Look.pixels(LINE), Short.MAX_VALUE);
            return cell;
        }
    }
}
