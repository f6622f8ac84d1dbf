package tompkins.ui.editor;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.TinyDrawing;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.Wording;

/** Controls for a record of a sealed family: a combo box of its types, and under it the form of the chosen one. */
final class FamilyEditor extends Part implements ValueEditor {

    private final JPanel formPanel = Rows.column();
    private final Consumer<Object> commit;
    private final Note note;
    private final JComboBox<Class<?>> types = new JComboBox<>();
    private final Note meaning = new Note("");
    private final Updating updating = new Updating();
    private Class<?> shownType;
    private Object shown;

    /** The value that was last made by choosing a type. */
    private Object made;

    /** What the values from which it came had of their own, the latest first. */
    private final List<KeptPart> kept = new ArrayList<>();

    private RecordForm form;

    FamilyEditor(Class<?> family, String name, Note note, Consumer<Object> commit) {
        super(Rows.column());
        this.commit = commit;
        this.note = note;
        Hiding.types(family).forEach(types::addItem);
        Naming.items(types, Wording::label, TinyDrawing::of);
        types.setName(name);
        types.getAccessibleContext().setAccessibleName(name);
        types.addActionListener(event -> updating.unless(this::choose));
        types.setVisible(types.getItemCount() > 1);
        panel.add(types, "wmin 0");
    }

    @Override
    public Optional<JComponent> parts() {
        return Optional.of(formPanel);
    }

    @Override
    public boolean isTall() {
        return true;
    }

    private void choose() {
        Class<?> chosen = (Class<?>) types.getSelectedItem();
        if (chosen == shownType) {
            return;
        }
        kept.addAll(0, ownParts());
        made = alike(chosen);
        if (!note.attempt(() -> commit.accept(made))) {
            updating.during(() -> types.setSelectedItem(shownType));
        }
    }

    /**
     * The default value of a type, with all parts that it has in common with the shown value, or with those from which
     * that was made, if they fit together.
     */
    private Object alike(Class<?> type) {
        Object standard = Descriptions.standard(type);
        Object[] values = Descriptions.components(type).stream()
                .map(component -> kept.stream()
                        .filter(part -> part.fits(component))
                        .findFirst()
                        .map(KeptPart::value)
                        .orElse(Descriptions.value(component, standard)))
                .toArray();
        try {
            return Descriptions.make(type, values);
        } catch (InvalidPropertyException doNotGoTogether) {
            return standard;
        }
    }

    /** The parts that differ from the default. */
    private List<KeptPart> ownParts() {
        Object usual = Descriptions.standard(shownType);
        return Descriptions.components(shownType).stream()
                .filter(own -> !Descriptions.value(own, shown).equals(Descriptions.value(own, usual)))
                .map(own -> new KeptPart(own, Descriptions.value(own, shown)))
                .toList();
    }

    /**
     * A part of a value. Numbers and yes-or-no choices are left out, because they mean something else in another type.
     */
    private record KeptPart(RecordComponent component, Object value) {

        boolean fits(RecordComponent other) {
            return other.getName().equals(component.getName())
                    && other.getGenericType().equals(component.getGenericType())
                    && (!other.getType().isPrimitive() || other.getDeclaringRecord() == component.getDeclaringRecord());
        }
    }

    @Override
    public void show(Object value) {
        if (!value.equals(made)) {
            kept.clear();
        }
        shown = value;
        if (value.getClass() != shownType) {
            shownType = value.getClass();
            updating.during(() -> types.setSelectedItem(shownType));
            meaning.setText(types.isVisible() ? Wording.meaning(shownType) : "");
            replaceForm();
        }
        form.show(value);
    }

    private void replaceForm() {
        formPanel.removeAll();
        formPanel.add(meaning.component(), "wmin 0");
        form = new RecordForm(shownType, component -> !Branches.isBranch(component.getGenericType()), commit);
        formPanel.add(form.component(), "wmin 0");
        formPanel.revalidate();
        formPanel.repaint();
    }
}
