// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/tape/format_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

namespace dgt::studio {
namespace {

constexpr int kLongestBlank = 10000;  // mm, as the setting has it

void set_texts(QComboBox* box, const QStringList& texts) {
  for (int i = 0; i < texts.size(); ++i) box->setItemText(i, texts[i]);
}

}  // namespace

FormatBox::FormatBox(Part part, const TapeFormat& format, QWidget* parent)
    : QWidget(parent), format_(format), part_(part) {
  leader_ = new QSpinBox(this);
  trailer_ = new QSpinBox(this);
  for (QSpinBox* const box : {leader_, trailer_}) {
    box->setRange(0, kLongestBlank);
    box->setSingleStep(50);
    connect(box, &QSpinBox::valueChanged, this, &FormatBox::changed);
  }
  leader_->setObjectName(QStringLiteral("leader"));
  leader_->setValue(static_cast<int>(format.leader));
  trailer_->setValue(static_cast<int>(format.trailer));
  const auto choice = [this](const char* name, int count, int index) {
    auto* box = new QComboBox(this);
    box->setObjectName(QString::fromLatin1(name));
    for (int i = 0; i < count; ++i) box->addItem(QString());
    box->setCurrentIndex(index);
    connect(box, &QComboBox::currentIndexChanged, this, &FormatBox::changed);
    return box;
  };
  start_ = choice("start", 2, format.start == TapeStart::Percent ? 0 : 1);
  line_end_ = choice("line_end", 2, format.line_end == TapeLineEnd::CrLf ? 0 : 1);
  unpunchable_ = choice("unpunchable", 3, static_cast<int>(format.unpunchable));
  checksum_ = choice("checksum", 2, format.checksum == TapeChecksum::None ? 0 : 1);
  before_start_ = choice("before_start", 2, format.before_start == BeforeStart::Checked ? 0 : 1);
  header_ = new QLineEdit(QString::fromStdString(format.header), this);
  header_->setObjectName(QStringLiteral("header"));
  connect(header_, &QLineEdit::textChanged, this, &FormatBox::changed);
  new QFormLayout(this);
  layout()->setContentsMargins(0, 0, 0, 0);
  const bool punches = part == Part::Punching;
  const std::vector<QWidget*> fields =
      punches ? std::vector<QWidget*>{leader_,   trailer_,     header_,  start_,
                                      line_end_, unpunchable_, checksum_}
              : std::vector<QWidget*>{start_, before_start_, checksum_};
  for (QWidget* const field :
       {static_cast<QWidget*>(leader_), static_cast<QWidget*>(trailer_),
        static_cast<QWidget*>(header_), static_cast<QWidget*>(start_),
        static_cast<QWidget*>(line_end_), static_cast<QWidget*>(unpunchable_),
        static_cast<QWidget*>(checksum_), static_cast<QWidget*>(before_start_)}) {
    if (std::ranges::find(fields, field) == fields.end()) field->hide();
  }
  for (QWidget* const field : fields) {
    auto* label = new QLabel(this);
    label->setBuddy(field);
    labels_.push_back(label);
    static_cast<QFormLayout*>(layout())->addRow(label, field);
  }
  retranslate();
}

TapeFormat FormatBox::format() const {
  TapeFormat format = format_;
  format.leader = static_cast<std::uint32_t>(leader_->value());
  format.trailer = static_cast<std::uint32_t>(trailer_->value());
  format.start = start_->currentIndex() == 0 ? TapeStart::Percent : TapeStart::None;
  format.line_end = line_end_->currentIndex() == 0 ? TapeLineEnd::CrLf : TapeLineEnd::Lf;
  format.unpunchable = static_cast<Unpunchable>(unpunchable_->currentIndex());
  format.checksum = checksum_->currentIndex() == 0 ? TapeChecksum::None : TapeChecksum::Line;
  format.before_start =
      before_start_->currentIndex() == 0 ? BeforeStart::Checked : BeforeStart::Ignored;
  format.header = header_->text().toStdString();
  return format;
}

void FormatBox::set_header(const QString& header) { header_->setText(header); }

void FormatBox::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void FormatBox::retranslate() {
  const QStringList names =
      part_ == Part::Punching
          ? QStringList{tr("Leader:"),  tr("Trailer:"),   tr("Lettering:"),
                        tr("Start:"),   tr("Line ends:"), tr("Unknown characters:"),
                        tr("Checksum:")}
          : QStringList{tr("Start:"), tr("Before the start:"), tr("Checksum:")};
  for (std::size_t i = 0; i < labels_.size(); ++i)
    labels_[i]->setText(names[static_cast<qsizetype>(i)]);
  for (QSpinBox* const box : {leader_, trailer_}) box->setSuffix(tr(" mm"));
  set_texts(start_, {tr("a line %"), tr("none")});
  set_texts(line_end_, {tr("CR LF"), tr("LF")});
  set_texts(unpunchable_, {tr("refused"), tr("left out"), tr("spelled in Latin letters")});
  set_texts(checksum_, {tr("none"), tr("a line before the %")});
  set_texts(before_start_, {tr("is checked"), tr("may be anything")});
  header_->setToolTip(tr("A text in holes before the %, for a person to read"));
}

}  // namespace dgt::studio
