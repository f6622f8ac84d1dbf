package tompkins.ui.editor;

import java.lang.reflect.RecordComponent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Tips;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.Wording;

/** Controls for a record of a sealed family: a combo box of its types, and under it the form of the chosen one. */
final class FamilyEditor implements ValueEditor {

    private final JPanel panel = Rows.column();
    private final Consumer<Object> commit;
    private final Note note;
    private final JComboBox<Class<?>> types = new JComboBox<>();
    private final Updating updating = new Updating();
    private Class<?> shownType;
    private Object shown;
    private RecordForm form;

    FamilyEditor(Class<?> family, String name, Note note, Consumer<Object> commit) {
        this.commit = commit;
        this.note = note;
        Descriptions.members(family).forEach(types::addItem);
        Naming.items(types, Wording::label);
        types.setName(name);
        types.getAccessibleContext().setAccessibleName(name);
        types.addActionListener(event -> updating.unless(this::choose));
        types.setVisible(types.getItemCount() > 1);
        panel.add(types, "wmin 0");
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public boolean isTall() {
        return true;
    }

    private void choose() {
        Class<?> chosen = (Class<?>) types.getSelectedItem();
        if (chosen != shownType && !note.attempt(() -> commit.accept(alike(chosen)))) {
            updating.during(() -> types.setSelectedItem(shownType));
        }
    }

    /**
     * A standard value of a type, with those parts of the shown value that it has, too, and that are not as usual, if
     * they go together. Numbers and choices of yes or no mean another thing in another type.
     */
    private Object alike(Class<?> type) {
        Object standard = Descriptions.standard(type);
        Object[] values = Descriptions.components(type).stream()
                .map(component -> ownPart(component).orElse(Descriptions.value(component, standard)))
                .toArray();
        try {
            return Descriptions.make(type, values);
        } catch (InvalidPropertyException doNotGoTogether) {
            return standard;
        }
    }

    private Optional<Object> ownPart(RecordComponent component) {
        Object usual = Descriptions.standard(shownType);
        return Descriptions.components(shownType).stream()
                .filter(own -> own.getName().equals(component.getName()))
                .filter(own -> own.getGenericType().equals(component.getGenericType()))
                .filter(own -> !own.getType().isPrimitive())
                .filter(own -> !Descriptions.value(own, shown).equals(Descriptions.value(own, usual)))
                .map(own -> Descriptions.value(own, shown))
                .findFirst();
    }

    @Override
    public void show(Object value) {
        shown = value;
        if (value.getClass() != shownType) {
            shownType = value.getClass();
            updating.during(() -> types.setSelectedItem(shownType));
            types.setToolTipText(Tips.wrapped(Wording.meaning(shownType)));
            replaceForm();
        }
        form.show(value);
    }

    private void replaceForm() {
        if (form != null) {
            panel.remove(form.component());
        }
        form = new RecordForm(shownType, component -> !Branches.isBranch(component.getGenericType()), commit);
        panel.add(form.component(), "wmin 0");
        panel.revalidate();
        panel.repaint();
    }
}
