package tompkins.ui.editor;

import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

/**
 * The tree and the form of the editor: side by side, where the tree gets the room that it needs and the form the rest;
 * or one above the other, so that the editor covers less of the picture.
 */
final class TreeAndForm {

    /** Sizes, in sizes of the type. */
    private static final double TREE_WIDTH = 18;

    private static final double LEAST_FORM_WIDTH = 26;
    private static final double FORM_WIDTH = 30;
    private static final double HEIGHT = 37;
    private static final double UPPER = 14;
    private static final double LOWER = 23;

    private final JComponent tree;
    private final JScrollPane trees;
    private final JScrollPane forms;
    private final JSplitPane split;

    TreeAndForm(JComponent tree, JComponent form) {
        this.tree = tree;
        trees = new JScrollPane(tree);
        forms = new JScrollPane(
                form, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        forms.setBorder(BorderFactory.createEmptyBorder());
        split = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, trees, forms);
        split.setResizeWeight(0.4);
        split.getAccessibleContext().setAccessibleName(Texts.get("tree.split"));
        // it would go from the tree to the form, and not begin a ride
        split.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("F6"), "none");
        fitToLook(false);
        tree.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                makeRoomForTree();
            }
        });
    }

    JComponent component() {
        return split;
    }

    /** Sets the sizes that do not follow the look by themselves; {@code tall} puts the form below the tree. */
    void fitToLook(boolean tall) {
        split.setOrientation(tall ? JSplitPane.VERTICAL_SPLIT : JSplitPane.HORIZONTAL_SPLIT);
        forms.setMinimumSize(new Dimension(Look.pixels(LEAST_FORM_WIDTH), 0));
        forms.setPreferredSize(
                new Dimension(Look.pixels(tall ? LEAST_FORM_WIDTH : FORM_WIDTH), Look.pixels(tall ? LOWER : HEIGHT)));
        trees.setPreferredSize(
                tall
                        ? new Dimension(0, Look.pixels(UPPER))
                        : new Dimension(Math.max(treeWidth(), Look.pixels(TREE_WIDTH)), 0));
        split.resetToPreferredSizes();
    }

    private int treeWidth() {
        return tree.getPreferredSize().width
                + trees.getVerticalScrollBar().getPreferredSize().width
                + trees.getInsets().left
                + trees.getInsets().right;
    }

    /** Gives an opened branch more room if it needs that; the form gives up what it can. */
    private void makeRoomForTree() {
        int most = split.getWidth() - split.getDividerSize() - forms.getMinimumSize().width;
        int wanted = Math.min(treeWidth(), most);
        if (split.getOrientation() == JSplitPane.HORIZONTAL_SPLIT && wanted > split.getDividerLocation()) {
            split.setDividerLocation(wanted);
        }
    }
}
